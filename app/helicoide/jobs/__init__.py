"""Long work: in processes, with progress."""
