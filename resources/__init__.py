"""What the application ships beside its code: icons, style, keymaps and the built-in demo shot."""
