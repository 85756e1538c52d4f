"""Reading points from text as various programs write it: encoding, columns, names and numbers."""
