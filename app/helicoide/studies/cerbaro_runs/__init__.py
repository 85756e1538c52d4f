"""What the studies of Cerbaro 2022 share: the arms, what they aim at, and runs step by step."""
