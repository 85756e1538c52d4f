"""What the studies of Cerbaro 2022 share: arms, tasks, and runs step by step."""
