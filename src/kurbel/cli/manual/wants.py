"""What people have or want, in their words, and the lines that do it: `kurbel help`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple


class Purpose(NamedTuple):
    """A want by its name, which is no command's: a sentence, lines with what each is, and pages to read."""

    name: str
    sentence: str
    lines: Sequence[tuple[str, str]]
    pages: str


WANTS = (
    Purpose(
        "motion",
        "I want the motion of a piston",
        (
            ("table --ratio 1:5", "path, velocity, acceleration"),
            ("table --stroke 600mm --rod 1500mm --speed 120/min", "in m and m/s"),
            ("table --ratio 1:5 --point 0.5", "of a point of the rod"),
            ("table --ratio 1:5 --angle 's=0..100%:5%'", "at shares of the stroke"),
            ("harmonics --ratio 1:5", "as a series of cosines"),
        ),
        "subjects/motion subjects/points subjects/approximations",
    ),
    Purpose(
        "linkage",
        "I have an offset crank, a four-bar, a beam engine or coupled axles",
        (
            ("table --mechanism offset --ratio 1:4 --offset 0.3", "an offset crank"),
            ("table --mechanism arc --ratio 1:5 --rocker 6", "the rod moves a rocker"),
            (
                "table --mechanism arc --stroke crank:80mm --rod 300mm --rocker 200mm --pivot '34cm;0'"
                " --circuit -1",
                "a four-bar",
            ),
            ("deadcentres --ratio 1:4 --offset 0.3", "its stroke and dead centres"),
            ("deadcentres --stroke true:100mm --time-ratio 1.25 --offset 50mm", "its crank and rod"),
            ("deadcentres --mechanism beam --beam 3", "those of a beam engine"),
            ("forces --mechanism parallel --axles 3", "coupled axles"),
        ),
        "subjects/motion subjects/forces",
    ),
    Purpose(
        "condition",
        "I want the angle, or the number, at which something holds",
        (
            ("solve --ratio 1:5 --where c=max", "the greatest velocity"),
            ("solve --ratio 1:5 --where 's = 50%'", "the middle of the stroke"),
            ("solve --machine engine.toml --where torque=max", "the greatest torque"),
            (
                "solve --ratio 1:4 --stroke 320mm --speed 200/min --where 's = 50%' --columns phi,time",
                "the time until then",
            ),
            ("solve --unknown ratio --angle 80 --where c=max", "the ratio for an angle"),
            (
                "solve --unknown speed --angle 20 --where rod_force=0 --stroke 115mm --reciprocating 1kg"
                " --force 5kN",
                "the speed at which the rod carries nothing",
            ),
        ),
        "subjects/solve",
    ),
    Purpose(
        "piston",
        "I have a force, a pressure or a weight on a piston",
        (
            ("forces --force 10kN --stroke 600mm --rod 1500mm", "in N and N m"),
            ("forces --bore 100mm --pressure-difference 2bar --stroke 120mm", "a pressure"),
            (
                "forces --bore 300mm --head-pressure 4bar --crank-pressure 1bar --stroke 400mm",
                "on both sides",
            ),
            ("forces --force 10kN --friction 500N", "with friction"),
            ("forces --at tangent", "rod and crank at right angles"),
        ),
        "subjects/forces subjects/effort",
    ),
    Purpose(
        "masses",
        "I have masses that move: a piston, a rod, their weight",
        (
            ("forces --stroke 600mm --rod 1500mm --speed 120/min --reciprocating 200kg", "a piston"),
            ("inertia --centre 0.6 --gyration 0.3", "a rod"),
            (
                "inertia --rod 1500mm --rod-mass 150kg --centre 0.6 --gyration 0.3 --layout rod-masses",
                "its masses at the pins",
            ),
            (
                "forces --stroke 600mm --speed 120/min --reciprocating 200kg --slope vertical --force 10kN",
                "a vertical engine",
            ),
        ),
        "subjects/forces subjects/effort",
    ),
    Purpose(
        "steam",
        "I have a steam engine",
        (
            ("forces --eps 4 --bore 300mm --pressure 8bar", "forces over the turn"),
            ("turning --eps 4 --ratio 1:5", "turning effort"),
            ("delta --eps 2..6 --ratio 1:5", "how evenly it turns"),
            ("flywheel --power 50kW --speed 120/min --delta 1:100 --eps 4", "its flywheel"),
            ("power --eps 4 --pressure 8bar --bore 300mm --stroke 600mm --speed 120/min", "its power"),
            ("pressures --machine engine.toml", "with its masses, over the stroke"),
        ),
        "subjects/engines subjects/irregularity",
    ),
    Purpose(
        "card",
        "I have an indicator card",
        (
            ("delta --card card.csv", "how evenly the engine turns"),
            ("turning --card card.csv", "turning effort"),
            ("forces --card card.csv --bore 300mm", "forces over the turn"),
            ("power --card card.csv --bore 300mm --stroke 600mm --speed 120/min", "power"),
        ),
        "subjects/cards",
    ),
    Purpose(
        "gas",
        "I have a gas engine",
        (
            ("delta --compression 6 --peak-pressure 30", "how evenly it turns"),
            ("turning --compression 6 --peak-pressure 30", "turning effort"),
            (
                "power --compression 6 --peak-pressure 30 --suction-pressure 1bar --bore 200mm --stroke 300mm"
                " --speed 5/s",
                "its power",
            ),
            ("firing --engine inline-4", "firing orders"),
        ),
        "subjects/engines subjects/loads",
    ),
    Purpose(
        "compressor",
        "I have a compressor",
        (
            ("turning --pressure-ratio 4 --clearance 5%", "turning effort"),
            ("delta --pressure-ratio 2..6", "how evenly it turns"),
            (
                "power --pressure-ratio 4 --suction-pressure 1bar --bore 300mm --stroke 600mm --speed 2/s",
                "its power",
            ),
        ),
        "subjects/engines subjects/loads",
    ),
    Purpose(
        "pump",
        "I have a pump",
        (
            ("turning --pump single", "turning effort"),
            ("delta --pump differential", "how evenly it turns"),
        ),
        "subjects/engines subjects/loads",
    ),
    Purpose(
        "work",
        "I want a mean pressure, a power, or the size of a cylinder",
        (
            ("power --eps 4 --pressure 8bar", "the mean effective pressure"),
            ("power --eps 4 --pressure 8bar --bore 300mm --stroke 600mm --speed 120/min", "a power"),
            ("power --eps 4 --pressure 8bar --power 50kW --stroke-bore 1.5 --speed 120/min", "a size"),
        ),
        "subjects/power",
    ),
    Purpose(
        "diagram",
        "I have a diagram of turning moments",
        (
            ("turning --torque '5000 + 1500 sin(3φ)'", "a formula"),
            ("turning --torque '0:0;60:400;180:0;360:0' --turns 1", "points"),
            (
                "flywheel --areas '+52;-124;+72' --area-scale '500 N m; 6°' --speed 600/min --delta ±1.5%",
                "areas, and the flywheel",
            ),
            ("flywheel --torque '5000 + 1500 sin(3φ)' --speed 300/min --delta 1%", "a flywheel for it"),
            (
                "flywheel --load-torque '0:500; 540:500; 540:1900; 810:1900; 810:500; 1080:500' --turns 3"
                " --speed 180/min --inertia '440 kg m2'",
                "of a machine that is driven",
            ),
        ),
        "subjects/diagrams subjects/flywheels",
    ),
    Purpose(
        "wheel",
        "I want a flywheel, or its rim",
        (
            ("flywheel --swing 5kJ --speed 300/min --delta ±1% --radius 1m", "from the energy"),
            (
                "flywheel --power 300kW --speed 90/min --energy-fluctuation 0.1 --delta ±0.5% --radius 2m",
                "from the power",
            ),
            ("flywheel --swing 56kJ --speed 120/min --mass 6.5t --radius 1.8m", "how even it runs"),
            (
                "flywheel --swing 56kJ --speed 120/min --delta 1:60 --rim-diameter 3m --density 7200kg/m³",
                "the section of its rim",
            ),
        ),
        "subjects/flywheels",
    ),
    Purpose(
        "press",
        "I have a press, a punch or a riveting machine",
        (
            (
                "flywheel --work 10kJ --strokes 30/min --share 1/4 --speed 200..225/min --radius 0.5m",
                "motor and flywheel",
            ),
            (
                "flywheel --hole '28mm x 16mm' --shear-strength 320MPa --strokes 20/min --share 1/10"
                " --speed 200/min --delta 10%",
                "holes in a plate",
            ),
            (
                "flywheel --work 9kJ --duration 1s --power 2kW --inertia '60kg m2' --greatest-speed 5/s",
                "how slow it gets, and how often it works",
            ),
            ("flywheel --inertia '48kg m2' --swing 6.5kJ --greatest-speed 320/min", "after one blow"),
        ),
        "subjects/flywheels",
    ),
    Purpose(
        "counterweights",
        "I have an engine, a rotor or a locomotive to balance",
        (
            ("balance --engine inline-4", "free forces and moments"),
            (
                "balance --engine inline-1 --stroke 120mm --speed 1200/min --reciprocating 1.5kg --share 1/2",
                "with a counterweight",
            ),
            (
                "rotor --masses '2kg;3kg' --radii '100mm;80mm' --angles '0;120' --planes '0;200mm'"
                " --balance-planes '50mm;150mm' --balance-radii 100mm",
                "masses in two planes",
            ),
            ("locomotive --spacing 0.7m --gauge 1.5m --stroke 60cm --reciprocating 300kg", "hammer blow"),
        ),
        "subjects/balance subjects/rotors subjects/locomotives",
    ),
    Purpose(
        "vibration",
        "I want the harmonics of a torque",
        (("harmonics --quantity torque --eps 4", "by orders"),),
        "subjects/excitation",
    ),
    Purpose(
        "book",
        "I want a table for my book",
        (
            ("table --ratio '1:4;1:5' --step 15 -o table.tex", "LaTeX; .docx, .html, .typ, .pdf likewise"),
            ("layouts", "pages as in books"),
            ("table --layout roetscher-112 -o page.html", "one of them"),
            ("inject notes.md", "at marked places of a text"),
            ("handbook init appendix/", "a whole appendix"),
        ),
        "howto/formats howto/latex howto/word howto/layouts howto/layout-list howto/handbook",
    ),
    Purpose(
        "printed",
        "I have a printed table, or a worked example, to check",
        (
            ("collate roetscher-112", "a table of a book"),
            ("collate --csv scan.csv --quantity p --ratio 1:4 --method series", "your own transcription"),
            ("example blau 33", "a worked example"),
            ("sources", "the books that there are"),
        ),
        "howto/sources books/others",
    ),
    Purpose(
        "drawing",
        "I want a drawing",
        (
            ("table --ratio 1:5 -o motion.svg", "curves"),
            ("forces --eps 4 --polar -o pin.svg", "a polar diagram"),
            ("plot --positions 30 --ratio 1:5 -o drive.svg", "the mechanism"),
            ("plot --animate --ratio 1:4 -o turn.html", "what moves"),
            ("construct blau-9 --ratio 1:4 --angle 50 -o fig9.svg", "a construction of a book"),
        ),
        "subjects/drawings subjects/constructions subjects/construction-list",
    ),
    Purpose(
        "combinations",
        "I want the numbers of many machines at once",
        (
            ("delta --eps 2..6 --ratio '1:4;1:5;1:6'", "on a page"),
            ("table --ratio 1:3..6 -o page.html --interactive", "a page with sliders"),
            ("sweep delta --eps 1.5..10:0.1 --ratio 1:3..8 -o delta.parquet", "a file of columns"),
        ),
        "howto/sweeps howto/interactive howto/columns",
    ),
    Purpose(
        "programs",
        "I want it in Python, a notebook or a spreadsheet",
        (
            ("table --ratio 1:5 -o table.xlsx", "a spreadsheet"),
            ("table --ratio 1:5 -f csv", "for another program"),
            ("table --ratio 1:5 -f json", "with all that is known of it"),
        ),
        "howto/python howto/notebooks howto/spreadsheets",
    ),
    Purpose(
        "english",
        "I want English words, inches, or more digits",
        (
            ("table --ratio 1:5 --lang en", "English; KURBEL_LANG=en for all"),
            ("table --stroke 12in --rod 30in --speed 120/min --lang en", "inches"),
            ("forces --force 10kN --stroke 600mm --units 'lbf;ft'", "in pounds and feet"),
            ("table --ratio 1:5 --digits 12", "more digits"),
        ),
        "howto/numbers-and-names",
    ),
)
