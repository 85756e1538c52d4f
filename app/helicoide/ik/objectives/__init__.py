"""Secondary objectives, a file each: what the joints do with the freedom that the task leaves them."""
