"""From a surface to the laboratory: is it fit to be delivered, in which form does it go, and what is certified of it.

- **One check, one verdict** (:mod:`~scanner_core.delivery.check`): pass, remark or fail, with the number, its limit and one sentence.
  What could not be checked says so; it is never a pass.  All of them together give one verdict, and no remark ever turns green.
- **Limits come from the use** (:mod:`~scanner_core.delivery.limits`), each with its reason beside it.
- **Left and right are told apart by shape** as far as they can be (:mod:`~scanner_core.delivery.side`): the two ears of one person are
  nearly each other's mirror image, so an ear that fits the other better than the other's mirror image is labelled wrongly, or twice there.
- **A profile** (:mod:`~scanner_core.delivery.profile`) is what a laboratory wants: format, unit, name, pose.
- **All files or none** (:mod:`~scanner_core.delivery.delivering`), the certificate and its JSON among them, and the case remembers it.
"""
