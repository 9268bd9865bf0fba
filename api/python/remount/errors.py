"""What every function raises for broken input and broken contracts."""


class Error(RuntimeError):
    """Broken input or a broken contract. What the numbers do not allow is no error: the status of a result says it.

    code         "io", "format", "unsupported", "contract" or "cancelled"
    place        file with line or byte ("scan.pcd:7"), or the name of what was given
    expectation  what was found, what was expected, and what to do where that is known
    """

    def __init__(self, code, place, expectation):
        super().__init__(f"{place}: {expectation}" if place else expectation)
        self.code = code
        self.place = place
        self.expectation = expectation

    def __reduce__(self):  # other processes send it as it is
        return type(self), (self.code, self.place, self.expectation)
