"""Points in text, as the many programs that write it do: its encoding, its columns and names, its numbers."""
