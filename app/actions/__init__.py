"""Every action by its id: what it is called, its keys, its menu, how it is found."""
