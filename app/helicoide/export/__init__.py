"""What leaves the lab as a file, a file each."""
