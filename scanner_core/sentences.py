"""What the program says when something goes wrong: one entry a code, English, in the technician's words.

``what`` says what happened and where; ``do`` says what is safe now and what to do.  Placeholders are named fields,
filled by the error that is raised.  A code never changes its meaning; the window translates by code.
"""

from __future__ import annotations

from scanner_core.finding_sentences import FINDING_SENTENCES
from scanner_core.sentence import Sentence

SENTENCES: dict[str, Sentence] = {
    # ------------------------------------------------------------------------------------------ use of the program
    "E-USE-01": Sentence("{what}.", "Nothing was changed; {do}."),
    # ------------------------------------------------------------------------------------------ cameras
    "E-CAM-01": Sentence(
        "Camera {camera} gave no frame within {seconds} s.",
        "The laser is off and the points so far are kept; check its cable and resume.",
    ),
    "E-CAM-02": Sentence("Camera {camera} was unplugged.", "The laser is off and the points so far are kept; plug it in and resume."),
    "E-CAM-03": Sentence("Camera {camera} was used after it had been closed.", "The laser is off; open the rig again."),
    "E-CAM-04": Sentence(
        "Camera {camera} delivered frames faster than they could be evaluated: {frames} frames are waiting.",
        "The laser is off and the points so far are kept; close other programs and resume.",
    ),
    "E-CAM-05": Sentence("Camera {camera} ({id}) is used by another program.", "Nothing was moved; close the other program and connect again."),
    "E-CAM-06": Sentence(
        "This user may not open camera {camera} ({id}).",
        "Nothing was moved; install the rule of packaging/udev or join the group 'video', then log in again.",
    ),
    "E-CAM-07": Sentence(
        "There is no camera {camera} ({id}); this machine has: {found}.", "Nothing was moved; plug it in, or correct 'id' in the rig file."
    ),
    "E-CAM-08": Sentence(
        "Camera {camera} gives frames of another kind than can be measured: {reason}.",
        "Nothing was measured; correct 'pixel_format' or 'size_px' in the rig file.",
    ),
    "E-CAM-09": Sentence(
        "Camera {camera} gives black frames.",
        "Nothing was measured; take the lens cap off, open the shutter, and look at 'exposure_ms' in the rig file.",
    ),
    "E-CAM-10": Sentence("Camera {camera} ({id}) cannot be opened: {reason}.", "Nothing was moved; unplug it, plug it in again, and connect again."),
    "E-CAM-11": Sentence(
        "Camera {camera} gives {measured_hz} frames/s where {wanted_hz} were asked for.",
        "Nothing was measured; plug it into a USB port of its own, choose a smaller size, or lower 'rate_hz' in the rig file.",
    ),
    "E-CAM-12": Sentence(
        "The software for cameras of the kind '{driver}' is not installed.", "Nothing was moved; run: pip install 'impronta[{driver}]'."
    ),
    "E-CAM-13": Sentence(
        "No trigger reached camera {camera} on {line} within {seconds} s.",
        'The laser is off and the points so far are kept; check the trigger cable, or set trigger = "free" in the rig file.',
    ),
    "E-CAM-14": Sentence(
        "Both cameras of the rig file are the same one ({id}).", "Nothing was moved; give the left and the right camera each an 'id' of its own."
    ),
    "E-CAM-15": Sentence(
        "Camera {camera} is driven through OpenCV, which cannot trigger it by {trigger}.",
        'Nothing was moved; write trigger = "free" into the rig file, or use a camera with a trigger of its own and its own driver.',
    ),
    "E-CAM-16": Sentence(
        "The left camera gives {left_hz} frames/s and the right one {right_hz}.",
        "Nothing was measured; give both the same 'rate_hz' in the rig file.",
    ),
    "E-CAM-20": Sentence("The recording {path} cannot be replayed: {reason}.", "Nothing was measured; choose another recording."),
    "E-CAM-21": Sentence(
        "The recording {path} holds no frames for what was asked of camera {camera}: {reason}.",
        "What was measured so far is kept; replay with the rig, plan and seed that it was recorded with.",
    ),
    "E-CAM-22": Sentence(
        "The frames of camera {camera} cannot be recorded into {path}: {reason}.",
        "The laser is off and the points so far are kept; free some space or choose another folder, and resume.",
    ),
    "E-CAM-30": Sentence(
        "Camera {camera} reported a fault: {reason}.",
        "The laser is off and the points so far are kept; unplug the camera, plug it in again, and resume.",
    ),
    "E-CAM-31": Sentence(
        "Camera {camera} cannot be triggered by {line}; it has: {lines}.", "Nothing was measured; correct 'trigger_line' in the rig file."
    ),
    # ------------------------------------------------------------------------------------------ controller
    "E-MOT-01": Sentence(
        "The controller on {port} did not answer '{command}' within {seconds} s.",
        "A reset was sent to switch the laser off and the points so far are kept; see that it is dark, check cable and power, then resume.",
    ),
    "E-MOT-02": Sentence(
        "The connection to the controller on {port} was lost.",
        "The points so far are kept. A sweep ends dark by itself, a standing spot may stay lit: see that the laser is off, plug it in, then resume.",
    ),
    "E-MOT-03": Sentence("The port {port} is used by another program.", "Nothing was moved; close the other program and connect again."),
    "E-MOT-04": Sentence("The controller on {port} was used after it had been closed.", "The laser is off; open the rig again."),
    "E-MOT-05": Sentence("The controller reports ALARM:{alarm} ({meaning}).", "The laser is off and the points so far are kept; {remedy}."),
    "E-MOT-06": Sentence(
        "The controller refused '{command}' with error:{number} ({meaning}).", "The laser is off; check the rig file and the controller's settings."
    ),
    "E-MOT-07": Sentence(
        "What answers on {port} is no GRBL controller (it said: {said}).", "Nothing was moved; choose another port in the rig file."
    ),
    "E-MOT-08": Sentence(
        "The port {port} does not exist or cannot be opened.", "Nothing was moved; plug the controller in or correct 'port' in the rig file."
    ),
    "E-MOT-09": Sentence(
        "The controller on {port} restarted by itself.", "The laser is off and the points so far are kept; its position is lost, home it and resume."
    ),
    "E-MOT-10": Sentence("The safety relay of the serial port stopped.", "The laser was switched off by a reset; connect again."),
    "E-MOT-11": Sentence(
        "The safety relay of the serial port {port} stopped, and the controller could not be reset.",
        "The laser may be on: switch off its power before you reach into the rig, then connect again.",
    ),
    "E-MOT-12": Sentence(
        "This user may not open the port {port}.",
        "Nothing was moved; install the rule of packaging/udev or join the group 'dialout', then log in again.",
    ),
    "E-MOT-13": Sentence(
        "The controller on {port} is not in laser mode ($32={value}).",
        "Nothing was moved; with $32=0 the beam would stand still while lit: send $32=1 to the controller once.",
    ),
    "E-MOT-14": Sentence(
        "The controller on {port} has no axis '{axis}' for the table (it has {axes}).",
        "Nothing was moved; correct 'table_axis' in the rig file.",
    ),
    "E-MOT-15": Sentence(
        "The motion was stopped during '{command}'.", "The laser is off and the points so far are kept; resume when the rig is free."
    ),
    "E-MOT-16": Sentence("The safety door of the rig is open.", "The laser is off and the points so far are kept; close the door and resume."),
    "E-MOT-17": Sentence(
        "The laser did not light although it was asked to.", "It was switched off again; check the controller's settings $30 to $32."
    ),
    "E-MOT-18": Sentence(
        "The controller reports a lit laser (S{power}) where it must be dark.",
        "A reset was sent to switch it off; see that it is dark, then check the controller's laser mode ($32).",
    ),
    "E-MOT-19": Sentence(
        "The program did not look after the lit laser for {seconds} s.",
        "The laser was switched off and the points so far are kept; free the machine of other work, then resume.",
    ),
    "E-MOT-20": Sentence(
        "The controller on {port} reports another position each time although it rests.",
        "A reset was sent and the points so far are kept; check the cable (length, shield, plugs) and resume.",
    ),
    "E-MOT-21": Sentence(
        "{axis} cannot go to {target} deg: {whose} allow {low} to {high} deg.", "Nothing was moved; choose another target, or correct the limits."
    ),
    "E-MOT-22": Sentence(
        "The controller on {port} does not tell its setting {setting} ({meaning}).",
        "Nothing was moved; install GRBL 1.1 or grblHAL with laser power on its PWM output.",
    ),
    "E-MOT-23": Sentence(
        "The controller on {port} runs {firmware}, which knows no laser mode.", "Nothing was moved; install GRBL 1.1 or newer on the controller."
    ),
    "E-MOT-24": Sentence(
        "Nothing answers on the port {port}.",
        "Nothing was moved; see that the controller has power and that the cable carries data, then check 'port' and 'baud' in the rig file.",
    ),
    # ------------------------------------------------------------------------------------------ rig, calibration, plan
    "E-AIM-01": Sentence(
        "What was set while aiming cannot be read ({path}: {reason}).",
        "The rig file's own settings are used; set exposure and sizes on the Aim page again.",
    ),
    "E-AIM-02": Sentence("The material {path} cannot be used: {reason}.", "It is left out of the list; correct the file or remove it."),
    "E-RIG-01": Sentence("The rig file {path} cannot be used: {reason}.", "Nothing was moved; correct the file or take one of the presets."),
    "E-RIG-02": Sentence(
        "The specimen is {size_mm} mm large, but both cameras see a volume of {volume_mm} mm.",
        "Nothing was scanned; choose a smaller specimen, or scale it (is its unit millimetres?).",
    ),
    "E-RIG-03": Sentence(
        "A rig needs a controller and two cameras that work; what was found: {controller}, cameras: {cameras}.",
        "No rig file was written; 'impronta doctor --find' says what became of every port and camera.",
    ),
    "E-CAL-01": Sentence("The calibration failed: {reason}.", "The previous calibration stays in use; take the views again."),
    "E-CAL-02": Sentence("The rig has no calibration.", "Nothing was measured; run 'impronta calibrate' or the Rig page first."),
    "E-CAL-03": Sentence("The calibration was not accepted: {reason}.", "It is not used; take more views with the board filling the volume."),
    "E-CAL-04": Sentence(
        "The board's squares measure {measured_mm} mm where {given_mm} mm was given (by the bar of {bar_mm} mm).",
        "The previous calibration stays in use; give the right size with --square-mm, or the bar's certified length with --length-mm.",
    ),
    "E-CAL-05": Sentence(
        "The cameras are exchanged: what is called the right camera stands to the left of the other.",
        "The previous calibration stays in use; exchange the two cameras in the rig file, then calibrate again.",
    ),
    "E-CAL-06": Sentence(
        "The calibration of this rig is not the one with which the scan in {path} was begun.",
        "What was measured is kept; use the rig file of that scan to resume it, or keep what is there and scan anew.",
    ),
    "E-PLAN-01": Sentence("The plan {path} cannot be used: {reason}.", "Nothing was scanned; correct the plan."),
    # ------------------------------------------------------------------------------------------ scan
    "E-SCAN-01": Sentence(
        "No surface was found: of {planned} planned measurements none gave a point ({reasons}).",
        "The laser is off; put the object on the table, and check the laser and the lens caps.",
    ),
    "E-SCAN-02": Sentence("The scan stopped on an unexpected fault ({reason}).", "The laser is off and the points so far are in {case}."),
    "E-SCAN-03": Sentence(
        "The interrupted scan cannot go on: of {known} known points {seen} were found again, {shift_um} um beside where they were.",
        "The laser is off and what was measured before is kept; put the object and the cameras back as they were and resume, or scan anew.",
    ),
    "E-SCAN-06": Sentence(
        "Room light drowned the laser spot: of {planned} planned measurements none gave a point.",
        "The laser is off and what was measured before is kept; switch the lamp off, then resume or scan again.",
    ),
    "E-SCAN-05": Sentence(
        "The {part} of the rig is not the one with which the scan in {path} was begun.",
        "What was measured is kept; use the rig file of that scan to resume it, or keep what is there and scan anew.",
    ),
    "E-MARK-01": Sentence(
        "The interrupted scan cannot go on: the marks on the table's rim are seen {shift_um} um beside where they were ({cause}).",
        "The laser is off and what was measured before is kept; put table and cameras back as they were and resume, or scan anew.",
    ),
    "E-SCAN-04": Sentence("{path} holds no interrupted scan.", "It was not touched; scan into a new case."),
    # ------------------------------------------------------------------------------------------ metrology
    "E-MET-01": Sentence("Nobody can place the artefacts of the test.", "Nothing was measured; run it where a person or the virtual bench can."),
    "E-MET-02": Sentence(
        "The standing spot was seen by both cameras in {seen} of {exposed} exposures only ({reasons}).",
        "The laser is off; put the matt white plate into the middle of the volume, facing the cameras, and keep the lamps away.",
    ),
    "E-MET-03": Sentence(
        "No sphere of {radius_mm} mm radius was found: {points} points were measured, {share} % of them lie on the best candidate.",
        "The laser is off; put the reference sphere alone into the middle of the table, and check the size that was given.",
    ),
    "E-MET-04": Sentence(
        "Two spheres stand on the table: {first} points lie on the one, {second} on the other.",
        "The laser is off; take all but one away and start the test again.",
    ),
    "E-MET-05": Sentence(
        "{points} points are too few for a sphere; at least {least} are needed.", "The laser is off; ask for more points, or more views."
    ),
    "E-MET-06": Sentence(
        "The ball bar was not found in position {position}: {found} of its two spheres was seen.",
        "The laser is off; place the bar as the plan of the test says, and check --reference-mm.",
    ),
    "E-MET-07": Sentence(
        "The spheres in position {position} stand {measured_mm} mm apart, not {reference_mm} mm.",
        "The laser is off; check --spacing-mm and that nothing else of the spheres' size stands in the volume.",
    ),
    # ------------------------------------------------------------------------------------------ case and disk
    "E-CASE-01": Sentence("{path} is no Impronta case: {reason}.", "The file was not touched; choose another file."),
    "E-CASE-02": Sentence("{path} is open in another window or program.", "Nothing was changed; close it there, or choose another case."),
    "E-CASE-03": Sentence(
        "{path} was written by a newer Impronta (case version {version}, this program knows {known}).",
        "It was not touched; open it with the newer program.",
    ),
    "E-CASE-04": Sentence("{path} does not exist.", "Nothing was changed; check the name."),
    "E-CASE-05": Sentence("{path} holds no {what} yet.", "The case is unchanged; {do}."),
    "E-CASE-06": Sentence("The case {path} was used after it had been closed.", "Everything written before is kept; open it again."),
    "E-CASE-07": Sentence(
        "A mesh of {triangles} triangles is too large to be kept in {path}.", "The case is unchanged; reconstruct with fewer triangles."
    ),
    # ------------------------------------------------------------------------------------------ coverage
    "E-COV-01": Sentence(
        "The mesh of {path} does not say how certain it is.", "The case is unchanged; reconstruct it with 'impronta reconstruct' and ask again."
    ),
    # ------------------------------------------------------------------------------------------ disk
    "E-DISK-01": Sentence(
        "There is no space left on the disk of {path}.", "The laser is off and everything written before is kept; free some space and go on."
    ),
    "E-DISK-02": Sentence("{path} cannot be written: {reason}.", "Nothing was changed; choose another folder or give permission."),
    "E-DISK-03": Sentence("{path} exists already.", "It was not touched; choose another name, or overwrite it with --force."),
    # ------------------------------------------------------------------------------------------ files from outside
    "E-FILE-01": Sentence("{path} does not exist.", "Nothing was done; check the name."),
    "E-FILE-02": Sentence("{path} is no mesh that can be read: {reason}.", "Nothing was done; use STL, PLY, OBJ, VTP or 3MF."),
    "E-FILE-03": Sentence("{path} holds no triangles.", "Nothing was done; export the mesh again from its program."),
    "E-FILE-04": Sentence("{path} cannot be read as points: {reason}.", "Nothing was done; use PLY, XYZ, TXT, CSV, ASC, NPY or a case."),
    "E-FILE-05": Sentence("{path} cannot be read: {reason}.", "Nothing was done; check the file."),
    "E-FILE-06": Sentence("Files of the kind '{suffix}' cannot be written.", "Nothing was written; use one of {known}."),
    "E-FILE-07": Sentence(
        "{path} cannot hold this mesh: so far from the origin the numbers of an STL file have steps of {step_mm} mm, wider than its triangles allow.",
        "Nothing was written; write .ply, .obj or .3mf instead, or move the points nearer to the origin.",
    ),
    # ------------------------------------------------------------------------------------------ reconstruction
    "E-REC-01": Sentence("{points} points are too few for a surface; at least {least} are needed.", "No mesh was written; scan more of the object."),
    "E-REC-02": Sentence("The points do not enclose a body: {reason}.", "No mesh was written; scan the object from more sides."),
    "E-REC-03": Sentence("The surface that was found is not trustworthy: {reason}.", "No mesh was written and the points are kept; {do}."),
    "E-REC-04": Sentence(
        "The points contain {count} values that are not finite numbers, or impossibly far away.", "No mesh was written; export the points again."
    ),
    "E-REC-05": Sentence(
        "The points belong to {count} separate objects: the second largest holds {share} % of them and lies {gap_mm} mm from the largest.",
        "No mesh was written; reconstruct one object at a time, and cut the points of the others off.",
    ),
    # ------------------------------------------------------------------------------------------ comparison: alignment
    "E-CMP-01": Sentence(
        "{after} and {before} do not fit onto each other: in the best pose only {score} % of the surface agrees. "
        "They seem to be different objects, or opposite sides of one.",
        "Both files are untouched; check that they show the same object and that the normals of both point outwards, then pick three points on both.",
    ),
    "E-CMP-02": Sentence(
        "{after} and {before} do not overlap: nothing of one lies within {reach_mm} mm of the other.",
        "Both files are untouched; let the program find the pose, or pick three points on both.",
    ),
    "E-CMP-03": Sentence(
        "One of {after} and {before} is mirrored, or they show opposite sides: {score} % of the surface agrees as it is, "
        "{mirrored} % of its mirror image.",
        "Both files are untouched and nothing was mirrored; choose the same side, or export the mirrored one again without mirroring.",
    ),
    "E-CMP-04": Sentence(
        "{name} holds too few measured triangles with an area: {triangles}, but a comparison needs at least {least}.",
        "The file is untouched; scan or export the surface again.",
    ),
    "E-CMP-05": Sentence(
        "The picked points do not say how the surfaces lie: {reason}.",
        "Nothing was changed; pick at least three points far from each other, in the same order on both surfaces.",
    ),
    "E-CMP-06": Sentence(
        "{area_mm2} mm2 with a counterpart are painted as stable; at least {least_mm2} mm2 are needed.",
        "Nothing was changed; paint more, or use the automatic frame.",
    ),
    # ------------------------------------------------------------------------------------------ mounts
    "E-LINE-01": Sentence(
        "A scan by a laser line is not steered by the uncertainty that it reaches.",
        "Nothing was measured; ask for a number of points instead, or scan by the spot.",
    ),
    "E-LINE-02": Sentence(
        "The right camera exposes {skew_us} us after the left one, and a moving laser line is then not the same line in both images.",
        "What was measured so far is kept and the laser is off; let a trigger line expose both cameras at once, then scan again.",
    ),
    "E-LINE-03": Sentence(
        "The interrupted scan of {path} was made by a laser line, which is not resumed.",
        "Nothing was touched, and what was measured can be used as it is; scan again into a new case, which takes about half a minute.",
    ),
    "E-MNT-01": Sentence(
        "The new mount fits nowhere on what was measured before: in the best pose only {agree} % of the surface that both show agrees.",
        "Nothing was joined and all points are kept; pick three points on both, or measure another mount that shares more with the earlier ones.",
    ),
    "E-MNT-02": Sentence(
        "The new mount shares too little with what was measured before: {overlap} % of it, and at least {least} % are needed.",
        "Nothing was joined and all points are kept; pick three points on both, or measure another mount that shares more with the earlier ones.",
    ),
    "E-MNT-03": Sentence(
        "The new mount fits in more than one way: a pose that is turned by {angle} degrees against the best one fits about as well.",
        "Nothing was joined and all points are kept; pick three points on both, or measure another mount that shares more with the earlier ones.",
    ),
    "E-MNT-04": Sentence(
        "The surface that both mounts show does not tell how they lie: {directions} of six directions of motion stay open, "
        "as on a ball or a cylinder.",
        "Nothing was joined and all points are kept; pick three points on both, or measure another mount that shares more with the earlier ones.",
    ),
    "E-MNT-05": Sentence(
        "In the best pose the new mount stands where light to the earlier one passed: {share} % of it.",
        "Nothing was joined and all points are kept; pick three points on both, or measure another mount that shares more with the earlier ones.",
    ),
    "E-MNT-06": Sentence(
        "The new mount, or what was measured before, has too few points to find its place: {points}, but at least {least} are needed.",
        "Nothing was joined and all points are kept; measure more of it.",
    ),
    "E-MNT-07": Sentence(
        "The picked points do not belong to each other: after the best fit of the surfaces they lie {apart_mm} mm apart.",
        "Nothing was joined and all points are kept; pick three points far from each other, in the same order on both.",
    ),
    "E-MNT-10": Sentence(
        "Mount {mount} was not joined to the others. {reason}",
        "All points are kept in {path}; pick three points on both mounts ('impronta register CASE --pairs FILE'), or scan another "
        "mount that shares more with the earlier ones.",
    ),
    "E-MNT-11": Sentence("Its surface lies nowhere over that of the others.", "All points are kept; measure another mount that shares more."),
    "E-MNT-12": Sentence(
        "Over the others its surface is {residual_um} um away (noise explains {most_um} um), and {agree} % of it agrees with theirs.",
        "Nothing was joined and all points are kept; see that the object did not change its shape, and measure the mount again.",
    ),
    "E-MNT-13": Sentence(
        "It contradicts the others: the loop of mounts would close with an error of {closure_um} um.",
        "Nothing was joined and all points are kept; see that the object did not change its shape, and measure the mount again.",
    ),
    "E-MNT-14": Sentence(
        "The file of picked points {path} cannot be used: {reason}.",
        "Nothing was changed; write one line a point: mount, x, y, z on that mount, and x, y, z of the same place on the first mount, in mm.",
    ),
    # ------------------------------------------------------------------------------------------ comparison
    "E-CMP-10": Sentence(
        "The marked part holds {marked} measured vertices; at least {least} are needed for a motion.",
        "Nothing was changed; mark more of the tooth.",
    ),
    "E-CMP-20": Sentence(
        "{path} holds too few triangles for a comparison: {triangles}, but at least {least} are needed.",
        "Nothing was compared; choose the whole surface.",
    ),
    "E-CMP-21": Sentence("The triangles of {path} all lie in one point or line.", "Nothing was compared; export the mesh again from its program."),
    "E-CMP-22": Sentence(
        "No part of the surface in {path} was measured: its vertices all say that nothing supports them.",
        "Nothing was compared; scan it again, or reconstruct it from its points.",
    ),
    "E-CMP-23": Sentence("The mask {path} cannot be used: {reason}.", "Nothing was compared; mark the stable part again."),
    "E-CMP-24": Sentence("The null comparison says nothing of the rig: {reason}.", "The rig file is unchanged; measure the same model twice."),
    "E-CMP-40": Sentence(
        "DICOM files are written by the package pydicom, which is not installed.",
        "Nothing was written; install it with pip install 'impronta[dicom]', or choose another format.",
    ),
    # ------------------------------------------------------------------------------------------ delivery
    "E-DLV-01": Sentence(
        "This surface is not ready to be delivered: {checks}.", "Nothing was written; mend that, or deliver it anyway, and the certificate says so."
    ),
    "E-DLV-02": Sentence("There is no export profile '{name}'.", "Nothing was written; use one of: {known}."),
    # ------------------------------------------------------------------------------------------ pair tray
    "E-TRAY-01": Sentence(
        "The two ears in {path} cannot be told apart: {count} points lie half way between the seats of the tray.",
        "Nothing was split and every point is kept; take those points out (Edit), or set the impressions on their seats and scan again.",
    ),
    "E-TRAY-02": Sentence(
        "Only {count} points in {path} lie on the seat of the {side} ear.",
        "Nothing was split and every point is kept; a single impression needs no tray, for a pair set both on their seats and scan again.",
    ),
    # ------------------------------------------------------------------------------------------ support bundle
    "E-SUP-01": Sentence("The support bundle has no entry '{name}'; it has {known}.", "Nothing was written; see what would be in it with --list."),
    # ------------------------------------------------------------------------------------------ memory and worker process
    "E-MEM-01": Sentence(
        "There is not enough memory for '{command}'.", "Nothing was written; close other programs, or ask for fewer points or triangles."
    ),
    "E-JOB-01": Sentence(
        "The worker process ended unexpectedly during {phase} ({reason}).",
        "Everything measured so far is safe and a new worker was started; run it again.",
    ),
    "E-JOB-02": Sentence("The worker process failed: {reason}.", "Everything measured so far is safe; send the log if it happens again."),
    **FINDING_SENTENCES,
}
