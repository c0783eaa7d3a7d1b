"""The exceptions of the instrument.

::

    ImprontaError
     +-- UsageError (ValueError)              the request itself makes no sense
     +-- DeviceError (OSError)
     |    +-- DeviceTimeoutError (TimeoutError)   no answer before the deadline
     |    +-- DeviceLostError (ConnectionError)   unplugged, reset, process gone
     |    +-- DeviceBusyError                     another program holds it
     |    +-- DeviceClosedError                   used after close()
     |    +-- ControllerAlarmError                the controller stopped by itself
     |    +-- MotionStoppedError                  stop() ended this motion; recover() comes first
     +-- CalibrationError (ValueError)        the views do not allow a calibration, or it was not accepted
     +-- AcquisitionError                     a scan could not go on
     +-- CaseError
     |    +-- CaseLockedError                     open in another program
     |    +-- CaseFormatError (ValueError)        no case, a newer case, a damaged case
     +-- StorageError (OSError)               disk full, no permission
     +-- InputFileError (ValueError)          a mesh, point, rig or plan file that cannot be used
     +-- ReconstructionError                  no trustworthy surface in these points
     +-- ComparisonError (ValueError)         two surfaces that cannot be compared
     +-- DeliveryError                        a surface cannot be delivered as it was asked for
     +-- WorkerError
          +-- WorkerLostError                     the worker process died; a new one was started

Every error carries a stable ``code`` whose sentences stand in :mod:`scanner_core.sentences`, the ``fields`` that
fill them, and ``details`` for the log.  ``str(error)`` is one line for a person: what happened, and what is safe
and what to do.  The window translates by code and fields.

Expected misses (no spot in a frame, a rejected pair, a registration that did not converge) are values, not
exceptions; a cancelled run is a finish reason, not an error.
"""

from __future__ import annotations

from scanner_core.sentences import SENTENCES


class ImprontaError(Exception):
    """Root of everything that the instrument raises on purpose.

    Parameters
    ----------
    code
        A key of :data:`scanner_core.sentences.SENTENCES`, for example ``"E-CAM-03"``.
    details
        For the log: exception texts, transcripts; never shown first.
    fields
        Values for the placeholders of the sentence.
    """

    def __init__(self, code: str, *, details: str = "", **fields: object) -> None:
        self.code = code
        self.details = details
        self.fields = fields
        sentence = SENTENCES[code]
        self.message = sentence.what.format(**fields)
        self.hint = sentence.do.format(**fields)
        super().__init__(f"{self.message} {self.hint} [{code}]")

    def __reduce__(self) -> tuple[object, ...]:
        return _rebuild, (type(self), self.code, self.details, self.fields)


def _rebuild(cls: type[ImprontaError], code: str, details: str, fields: dict[str, object]) -> ImprontaError:
    return cls(code, details=details, **fields)


class UsageError(ImprontaError, ValueError):
    """The request itself makes no sense."""


class DeviceError(ImprontaError, OSError):
    """A camera, the controller or its port."""


class DeviceTimeoutError(DeviceError, TimeoutError):
    """No answer before the deadline."""


class DeviceLostError(DeviceError, ConnectionError):
    """The device went away: unplugged, reset, its process gone."""


class DeviceBusyError(DeviceError):
    """Another program holds the device."""


class DeviceClosedError(DeviceError):
    """Used after ``close()``."""


class ControllerAlarmError(DeviceError):
    """The controller stopped by itself."""


class MotionStoppedError(DeviceError):
    """``stop()`` ended this motion; nothing moves before ``recover()``."""


class CalibrationError(ImprontaError, ValueError):
    """The views do not allow a calibration, or it was not accepted."""


class AcquisitionError(ImprontaError):
    """A scan could not start or could not go on."""


class CaseError(ImprontaError):
    """The case file."""


class CaseLockedError(CaseError):
    """The case is open in another program."""


class CaseFormatError(CaseError, ValueError):
    """Not a case, a newer case, or a damaged one."""


class StorageError(ImprontaError, OSError):
    """Disk full, or no permission."""


class InputFileError(ImprontaError, ValueError):
    """A mesh, point, rig or plan file that cannot be used."""


class ReconstructionError(ImprontaError):
    """No trustworthy surface in these points."""


class ComparisonError(ImprontaError, ValueError):
    """Two surfaces cannot be compared (``E-CMP``)."""


class DeliveryError(ImprontaError):
    """A surface cannot be delivered as it was asked for (``E-DLV``)."""


class WorkerError(ImprontaError):
    """The worker process."""


class WorkerLostError(WorkerError):
    """The worker process died; a new one was started."""
