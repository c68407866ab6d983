"""What pages say of steam and cards, of compressors, pumps and gas engines, in both languages."""

from __future__ import annotations

from kurbel.engine.loads.driven import DIFFERENTIAL, DOUBLE, SINGLE
from kurbel.engine.loads.ideal import DIESEL, DUAL, OTTO
from kurbel.page.quantity import words

OTHERS = {
    "isothermal": words("Verdichtung nach Mariotte (--exponent)|Compression by Mariotte's law (--exponent)"),
    "polytropic": words(
        'Verdichtung nach $p V^n = "const"$, $n = {exponent}$'
        '|Compression by $p V^n = "const"$, $n = {exponent}$'
    ),
    "clearance": words(
        "schädlicher Raum ${clearance}$ des Hubraumes, aus dem die Luft sich wieder ausdehnt"
        "|clearance ${clearance}$ of the swept volume, out of which the air expands again"
    ),
    "unclear": words("ohne schädlichen Raum (--clearance)|no clearance (--clearance)"),
    "lossless": words(
        "Ventile ohne Verluste (--suction-loss, --delivery-loss)"
        "|valves without losses (--suction-loss, --delivery-loss)"
    ),
    "suction_loss": words(
        "im Zylinder beim Saugen $p_1 (1 - {share})$|in the cylinder at suction $p_1 (1 - {share})$"
    ),
    "delivery_loss": words("beim Ausschieben $p_2 (1 + {share})$|at delivery $p_2 (1 + {share})$"),
    "other_side": words("auf der anderen Kolbenseite ${share} p_1$|on the other face ${share} p_1$"),
    "same_side": words(
        "auf der anderen Kolbenseite $p_1$ (--other-side)|on the other face $p_1$ (--other-side)"
    ),
    "above": words(
        "Saugdruck ${head}$ über dem der anderen Kolbenseite"
        "|suction pressure ${head}$ above that on the other face"
    ),
    "below": words(
        "Saugdruck ${head}$ unter dem der anderen Kolbenseite"
        "|suction pressure ${head}$ below that on the other face"
    ),
    "no_suction_head": words(
        "Saugdruck gleich dem auf der anderen Kolbenseite (--suction-pressure)"
        "|suction pressure that on the other face (--suction-pressure)"
    ),
    "ring": words(
        "Ringfläche ${share}$ der Kolbenfläche{usual}, stets unter dem Förderdruck"
        "|ring ${share}$ of the piston's area{usual}, always under the delivery pressure"
    ),
    "both": words(
        "Exponent der Verdichtung und der Ausdehnung ${exponent}$"
        "|exponent of compression and expansion ${exponent}$"
    ),
    "unraised": words("Auspuffdruck $p_1$ (--exhaust-pressure)|exhaust pressure $p_1$ (--exhaust-pressure)"),
    "apart": words(
        "Exponent der Verdichtung ${compression}$, der Ausdehnung ${expansion}$"
        "|exponent of compression ${compression}$, of expansion ${expansion}$"
    ),
    "peak": words("Höchstdruck ${peak} p_1$|peak pressure ${peak} p_1$"),
    "cut_off": words("Einspritzverhältnis ${cut_off}$|cut-off ratio ${cut_off}$"),
    "heat": words("Wärme $q = {heat} R T_1$|heat $q = {heat} R T_1$"),
    "exhaust": words("Auspuffdruck ${exhaust} p_1$|exhaust pressure ${exhaust} p_1$"),
    "four": words(
        "Viertakt (sonst --two-stroke), 0° im inneren Totpunkt bei der Zündung"
        "|four-stroke (else --two-stroke), 0° at the inner dead centre of firing"
    ),
    "two": words(
        "Zweitakt, 0° im inneren Totpunkt bei der Zündung|two-stroke, 0° at the inner dead centre of firing"
    ),
}
PUMP_KINDS = {
    DOUBLE: words("doppeltwirkend|double-acting"),
    SINGLE: words("einfachwirkend|single-acting"),
    DIFFERENTIAL: words("Differentialpumpe|differential"),
}
PUMPS = {
    DOUBLE: words("Pumpe doppeltwirkend (sonst --pump single)|Double-acting pump (else --pump single)"),
    SINGLE: words("Pumpe einfachwirkend|Single-acting pump"),
    DIFFERENTIAL: words("Differentialpumpe|Differential pump"),
}
CYCLES = {
    OTTO: words("Otto-Prozess (--cycle)|Otto cycle (--cycle)"),
    DIESEL: words("Diesel-Prozess|Diesel cycle"),
    DUAL: words("gemischter Prozess (Seiliger)|dual cycle (Seiliger)"),
}


OF_STEAM = {
    "single": words("einfachwirkend|single-acting"),
    "double": words("doppeltwirkend (sonst --single-acting)|double-acting (else --single-acting)"),
    "cranks": words(
        "Kurbeln um {angles} hinter der ersten, Zylinder gleich"
        "|cranks {angles} behind the first, cylinders alike"
    ),
    "card": words(
        "Druck aus dem Diagramm, monoton interpoliert; gedruckt sind nur so viele Stellen, wie seine"
        " Punkte tragen, für die übrigen vor dem Komma Nullen"
        "|pressure from the card, interpolated monotonically; only as many digits as its points support"
        " are printed, zeros for the others before the decimal mark"
    ),
    "mariotte": words("Expansion nach Mariotte (--exponent)|Expansion by Mariotte's law (--exponent)"),
    "polytropic": words(
        'Expansion nach $p V^n = "const"$, $n = {exponent}$|Expansion by $p V^n = "const"$, $n = {exponent}$'
    ),
    "uncut": words("Volldruck über den ganzen Hub|Full pressure over the whole stroke"),
    "clearance": words(
        "schädlicher Raum ${clearance}$ des Hubraumes|clearance ${clearance}$ of the swept volume"
    ),
    "unclear": words("ohne schädlichen Raum (--clearance)|no clearance (--clearance)"),
    "release": words(
        "Vorausströmung von {share} des Hubes an, gleichmäßig bis zum Gegendruck"
        "|release at {share} of the stroke, evenly down to the back pressure"
    ),
    "cushion": words(
        "Kompression von {share} des Rückgangs an, nach dem Gesetz der Expansion"
        "|cushioning from {share} of the return stroke on, by the law of the expansion"
    ),
    "lead": words(
        "Voreilung {share} des Hubes, gleichmäßig bis zum Dampfdruck"
        "|lead {share} of the stroke, evenly up to the steam pressure"
    ),
    "best": words(
        "Gegendruck ${back} = {full}/ε$, der vorteilhafteste (--back)"
        "|back pressure ${back} = {full}/ε$, the most favourable (--back)"
    ),
    "best_end": words(
        "Gegendruck gleich der Endspannung des Dampfes, der vorteilhafteste (--back)"
        "|back pressure equal to the steam's at the end of the stroke, the most favourable (--back)"
    ),
    "back": words("Gegendruck $R_b = {back}$|back pressure $R_b = {back}$"),
}
