"""Small renderers of other programs' files, each as that program composites; they share no code with our writers."""
