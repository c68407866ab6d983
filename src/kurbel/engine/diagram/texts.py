"""What pages of turning-moment diagrams and of their flywheels say, in both languages."""

from __future__ import annotations

from collections.abc import Mapping

from kurbel.page.quantity import Words, words

WORDS: Mapping[str, Words] = {
    "signs": words(
        "$T$ Drehmoment des Antriebs, $T_L$ der Last, positiv, wo sie ihn hemmt, $W$ Arbeit von $T - T_L$"
        " seit $0°$: am größten, wo die Drehzahl am größten ist"
        "|$T$ torque of the drive, $T_L$ of the load, positive where it resists, $W$ work of $T - T_L$ since"
        " $0°$: greatest where the speed is"
    ),
    "area_signs": words(
        "Flächen über der Mittellinie positiv, $a$ vor der ersten Fläche, $b$ hinter ihr; $W$ seit $a$, am"
        " größten, wo die Drehzahl am größten ist"
        "|areas above the mean line positive, $a$ before the first, $b$ behind it; $W$ since $a$, greatest"
        " where the speed is"
    ),
    "load": words("$T_L$ gleichbleibend, das Mittel von $T$|$T_L$ constant, the mean of $T$"),
    "drive": words("$T$ gleichbleibend, das Mittel von $T_L$|$T$ constant, the mean of $T_L$"),
    "lines": words("Punkte durch Geraden verbunden|points joined by straight lines"),
    "triangles": words(
        "Dreiecke gleicher Breite, ihre Spitzen in der Mitte"
        "|triangles alike in width, their peaks in the middle"
    ),
    "jumps": words("an Sprüngen der Wert dahinter|at jumps the value behind"),
    "cranks": words(
        "gleiche Diagramme, um {angles} versetzt, überlagert|diagrams alike, {angles} apart, superposed"
    ),
    "cycle": words("Spiel von ${turns}$ Umdrehungen|cycle of ${turns}$ turns"),
    "one_cycle": words("Spiel von einer Umdrehung|cycle of one turn"),
    "scale": words("eine Flächeneinheit ${scale}$|a unit of area ${scale}$"),
    "mean": words("mittleres Moment ${mean}$|mean torque ${mean}$"),
    "work": words("Arbeit des Spieles ${work}$|work of a cycle ${work}$"),
    "swing": words("Arbeitsüberschuss $ΔW = {swing}$|energy swing $ΔW = {swing}$"),
    "extremes": words(
        "Drehzahl am größten bei {greatest}, am kleinsten bei {least}"
        "|speed greatest at {greatest}, least at {least}"
    ),
    "power": words("Leistung ${power}$|power ${power}$"),
    "run": words(
        "$J = {inertia}$, {speed}, Mittel aus größter und kleinster"
        "|$J = {inertia}$, {speed}, mean of the greatest and the least"
    ),
    "irregularity": words(
        'Ungleichförmigkeitsgrad $δ = (ΔW)/(J ω^2) = {delta}$, $n_"max" = {most} "min"^(-1)$,'
        ' $n_"min" = {least} "min"^(-1)$'
        '|degree of irregularity $δ = (ΔW)/(J ω^2) = {delta}$, $n_"max" = {most} "min"^(-1)$,'
        ' $n_"min" = {least} "min"^(-1)$'
    ),
    "mass": words("$J = {inertia}$"),
}
ACCELERATION = words(
    'Winkelbeschleunigung $α = (T - T_L)/J$ am größten {most} $"rad"/"s"^2$ bei {high}, am kleinsten'
    ' {least} $"rad"/"s"^2$ bei {low}'
    '|angular acceleration $α = (T - T_L)/J$ greatest {most} $"rad"/"s"^2$ at {high}, least'
    ' {least} $"rad"/"s"^2$ at {low}'
)
FROM_TO = words("{start} bis {end}|{start} to {end}")
SWING, FLUCTUATION, PRESS, AREAS, TORQUE = "swing", "fluctuation", "press", "areas", "torque"
# What the energy swing is known from.
SOURCES: Mapping[str, Words] = {
    SWING: words("Schwungrad nach dem Arbeitsüberschuss|Flywheel by the energy swing"),
    FLUCTUATION: words(
        "Schwungrad nach dem Anteil des Arbeitsüberschusses"
        "|Flywheel by the coefficient of fluctuation of energy"
    ),
    PRESS: words("Schwungrad einer Presse|Flywheel of a press"),
    AREAS: words(
        "Schwungrad nach den Flächen des Drehmomentdiagramms"
        "|Flywheel by the areas of the turning-moment diagram"
    ),
    TORQUE: words("Schwungrad nach dem Verlauf des Drehmoments|Flywheel by the turning-moment diagram"),
    "": words("Schwungrad|Flywheel"),
}
OF_WHEELS: Mapping[str, Words] = {
    "speeds": words(
        '$ΔW = J ω^2 δ$ mit $ω = (ω_"max" + ω_"min")/2$ und $δ = (ω_"max" - ω_"min")/ω${exactly}'
        '|$ΔW = J ω^2 δ$ with $ω = (ω_"max" + ω_"min")/2$ and $δ = (ω_"max" - ω_"min")/ω${exactly}'
    ),
    "rim_speeds": words(
        '{swing} $= m_R v^2 δ$ mit $v = (v_"max" + v_"min")/2$ und $δ = (v_"max" - v_"min")/v$, genau: die'
        " Masse im mittleren Durchmesser, $v$ ihre Geschwindigkeit"
        '|{swing} $= m_R v^2 δ$ with $v = (v_"max" + v_"min")/2$ and $δ = (v_"max" - v_"min")/v$, exactly:'
        " the mass at the mean diameter, $v$ its speed"
    ),
    "exactly": words(", genau|, exactly"),
    "run_up": words(
        "Aus der Ruhe mit gleichbleibendem Drehmoment: $M_a = J ω/t_a$, $2 π u_a = ω t_a/2$,"
        " $W_a = J ω^2/2$; eine Kupplung an einer Welle, die $ω$ behält, verliert ebensoviel, $W_k = W_a$"
        "|From rest under a constant torque: $M_a = J ω/t_a$, $2 π u_a = ω t_a/2$, $W_a = J ω^2/2$; a clutch"
        " on a shaft that keeps $ω$ loses as much, $W_k = W_a$"
    ),
    "mass": words("$J = m k^2$"),
    "cycle": words(
        "$W$ Arbeit eines Spiels von {turns}|$W$ work of a cycle of {turns}"
    ),
    "turn": words("einer Umdrehung|one turn"),
    "turns": words("${turns}$ Umdrehungen|${turns}$ turns"),
    "press": words(
        "die Presse arbeitet während des Teils ${share}$ des Spiels, der Motor gibt stets die Leistung $N$:"
        " $ΔW = {rest} W$"
        "|the press works during the share ${share}$ of the cycle, the motor gives the power $N$ throughout:"
        " $ΔW = {rest} W$"
    ),
    "blow": words(
        "das Schwungrad leistet die Arbeit allein: $ΔW = W$|the flywheel does the work alone: $ΔW = W$"
    ),
    "stress": words("$v = ω D/2$, $σ = ρ v^2$"),
    "rim": words(
        "$m_R = ρ A π D$, $J_R = m_R D^2/4$: die Masse im mittleren Durchmesser"
        "|$m_R = ρ A π D$, $J_R = m_R D^2/4$: the mass at the mean diameter"
    ),
    "density": words("$ρ = {density} {unit}$"),
    "limit": words(
        "der Kranz hat den größten Durchmesser, den $σ$ erlaubt"
        "|the rim has the greatest diameter that $σ$ allows"
    ),
    "rim alone": words(
        "Arme und Nabe sind nicht gerechnet (--rim-share)|arms and hub are not counted (--rim-share)"
    ),
    "disc_stress": words(
        "$σ = (3 + ν)/8 ρ (ω D/2)^2$ in der Mitte der Scheibe, ohne Bohrung, $ν = {poisson}$"
        "|$σ = (3 + ν)/8 ρ (ω D/2)^2$ in the middle of the disc, without a hole, $ν = {poisson}$"
    ),
    "disc": words("Scheibe: $J = m D^2/8$, $m = ρ π D^2 t/4$|disc: $J = m D^2/8$, $m = ρ π D^2 t/4$"),
    "at angle": words("$α$ steht bei $φ = {angle}°$|$α$ stands at $φ = {angle}°$"),
    "places": words("Geschwindigkeit am größten bei {high}, am kleinsten bei {low}"
                      "|speed greatest at {high}, least at {low}"),
    "letters": words(
        "$a$ vor der ersten Fläche, $b$ hinter ihr und so fort"
        "|$a$ before the first area, $b$ behind it, and so on"
    ),
}  # fmt: skip
