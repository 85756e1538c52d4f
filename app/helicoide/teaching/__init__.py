"""What `import helicoide` offers in a notebook: arms, multivectors that print themselves, and the lab in a cell."""
