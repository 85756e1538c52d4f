"""The subcommands of `helicoide`, a file each, each with a `run` function."""
