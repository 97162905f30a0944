"""What a text declares: variables, types, blocks and their members, names, tasks."""
