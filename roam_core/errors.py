"""The one exception that reaches a user: a sentence that says what is wrong, where, and what to do."""


class RoamError(Exception):
    """Bad input or a failed operation, told in one clear sentence for the person at the screen.

    The command line prints the message and exits non-zero; the window shows it in place. Anything else that is raised
    is a defect of the program.
    """
