"""Long work in other processes, with progress."""
