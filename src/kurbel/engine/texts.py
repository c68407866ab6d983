"""What pages of engines say, in both languages."""

from __future__ import annotations

from collections.abc import Mapping

from kurbel.drive.load import CARD, COMPRESSOR, GAS, PUMP, STEAM
from kurbel.page.quantity import Words, words

ENGINE = {
    "first_order": words(
        "Erste Ordnung, $φ$ vom inneren Totpunkt: Weg und Arbeit mit $1 - cos φ + 1/2 λ sin^2 φ$"
        "|First order, $φ$ from the inner dead centre: path and work with $1 - cos φ + 1/2 λ sin^2 φ$"
    ),
    "first_order_masses": words(
        "Massen mit $p$ als $cos φ + λ cos 2 φ$, $ε_L$ als $-λ sin φ$"
        "|masses with $p$ as $cos φ + λ cos 2 φ$, $ε_L$ as $-λ sin φ$"
    ),
    "first_order_forces": words(
        "Kräfte beim genauen Winkel $ψ$ der Stange, $T$ mit $sin(φ + ψ)/(cos ψ)$"
        "|forces at the exact angle $ψ$ of the rod, $T$ with $sin(φ + ψ)/(cos ψ)$"
    ),
    "first_order_energy": words(
        "Energie der Massen mit $c$ als $sin φ + 1/2 λ sin 2 φ$, $ω_L$ als $λ cos φ$"
        "|energy of the masses with $c$ as $sin φ + 1/2 λ sin 2 φ$, $ω_L$ as $λ cos φ$"
    ),
    "first_order_work": words(
        "daher wächst $W$ nicht genau mit $T - P$|hence $W$ does not quite grow with $T - P$"
    ),
    "first_order_mean": words(
        "$P$ aus der Arbeit, daher nicht genau das Mittel von $T$"
        "|$P$ from the work, hence not quite the mean of $T$"
    ),
    "makes_delta": words("aus diesen beiden folgt $δ$|$δ$ follows from these two"),
    "delta": words('$δ = (v_"max" - v_"min")/v_1$'),
    "mean_force": words("$P$ mittlere Umfangskraft|$P$ mean tangential force"),
    "flywheel_mass": words(
        "$m_1$ Schwungmasse {at_radius}, $v_1$ Kurbelgeschwindigkeit im inneren Totpunkt"
        "|$m_1$ flywheel mass {at_radius}, $v_1$ crank-pin velocity at the inner dead centre"
    ),
    "at_crank_radius": words("am Kurbelhalbmesser $r$|at the crank radius $r$"),
    "at_radius": words("bei $r$|at $r$"),
    "framed": words(
        "{letters} positiv in der Richtung des Hinganges und nach der Seite, auf der dort der"
        " Kurbelzapfen läuft"
        "|{letters} positive in the direction of the outstroke and towards the side on which the"
        " crank pin then runs"
    ),
    "framed along": words(
        "{letters} positiv in der Richtung des Hinganges|{letters} positive in the direction of the outstroke"
    ),
    "framed across": words(
        "{letters} positiv nach der Seite, auf der beim Hingang der Kurbelzapfen läuft"
        "|{letters} positive towards the side on which the crank pin runs on the outstroke"
    ),
    "all_cranks": words(", von allen Kurbeln|, of all cranks"),
    "first_crank": words("die übrigen der ersten Kurbel|the others of the first crank"),
    "massless": words("ohne Massen|without masses"),
    "flywheel": words(
        "$(ΔW)/(P r)$ ist $δ$ in $(P r)/(m_1 v_1^2)$, $J = (ΔW)/(δ ω^2)$;"
        " $P$ mittlere Umfangskraft {at_radius}"
        "|$(ΔW)/(P r)$ is $δ$ in $(P r)/(m_1 v_1^2)$, $J = (ΔW)/(δ ω^2)$;"
        " $P$ mean tangential force {at_radius}"
    ),
    "true_inertia": words(
        "mit $J_δ$ bleibt die Geschwindigkeit der Maschine mit ihren Massen genau in $ω (1 ± δ/2)$"
        "|with $J_δ$ the speed of the machine with its masses stays exactly within $ω (1 ± δ/2)$"
    ),
    "radius": words("$ρ = {radius}$"),
    "turn": words(
        "Winkel vom Totpunkt des Hubes, in der Umdrehung vom inneren Totpunkt"
        "|Angles from the dead centre of the stroke, over the turn from the inner one"
    ),
    "whole_turn": words(
        "Winkel vom inneren Totpunkt der ersten Kurbel|Angles from the inner dead centre of the first crank"
    ),
    "from_slide": words(
        "$α$ vom inneren Totpunkt, $φ$ anderer Seiten von der Schubrichtung: $φ = α + φ_i$"
        "|$α$ from the inner dead centre, $φ$ of other pages from the slide direction: $φ = α + φ_i$"
    ),
    "strokes_from_slide": words(
        "$φ$ anderer Seiten von der Schubrichtung: $φ = α + φ_i$, wo Rückgang steht $φ = α + φ_o$"
        "|$φ$ of other pages from the slide direction: $φ = α + φ_i$, where Return stands $φ = α + φ_o$"
    ),
    "over_slide": words(
        "$φ$ von der Schubrichtung, der innere Totpunkt bei $φ_i$; $α$ anderer Seiten in der Umdrehung von"
        " dort: $φ = α + φ_i$"
        "|$φ$ from the slide direction, the inner dead centre at $φ_i$; $α$ of other pages over the turn from"
        " there: $φ = α + φ_i$"
    ),
    "difference": words(
        "Unterschied: genauer Wert weniger Näherung, vor dem Runden gebildet."
        "|Difference: exact value less approximation, taken before rounding."
    ),
    "weisbach": words(
        "$sin α_1 = P/(Q - R_b) ± r/(2 l) sin 2 α_1$,"
        " $P tan(α_2/2) = 2 Q/ε (1 ± r/l q) - 2 R_b q (1 ∓ r/l cos α_2)$, $q = sin^2(α_2/2)$;"
        " oberes Zeichen: Rückgang, unteres Zeichen: Hingang"
        "|$sin α_1 = P/(Q - R_b) ± r/(2 l) sin 2 α_1$,"
        " $P tan(α_2/2) = 2 Q/ε (1 ± r/l q) - 2 R_b q (1 ∓ r/l cos α_2)$, $q = sin^2(α_2/2)$;"
        " upper sign: return stroke, lower sign: outstroke"
    ),
}
SIGNS = {
    "signs": words(
        "Die Welle treibt den Kolben: $T$ zählt in der Drehrichtung, Arbeit als abgegeben; das Mittel $P$ ist"
        " negativ"
        "|The shaft drives the piston: $T$ counts as the crank turns, work as delivered; the mean $P$ is"
        " negative"
    ),
    "magnitude": words("$δ$ im Betrag von $P$|$δ$ in the magnitude of $P$"),
    "mean": words("$P r$ im Betrag|$P r$ as a magnitude"),
    "exchanged": words(
        "größte und kleinste Geschwindigkeit haben gegen die Kraftmaschine die Plätze getauscht"
        "|greatest and least speed have changed places with those of a driving machine"
    ),
    "supplied": words("{names} positiv, als zugeführt|{names} positive, as supplied"),
    "turning_sense": words(
        "Dreht der Kurbelzapfen im inneren Totpunkt nach oben, trägt bei liegender Maschine die obere"
        " Gleitbahn; Arbeitsmaschinen drehen daher anders herum als Kraftmaschinen, und die untere trägt"
        "|Where the crank pin rises at the inner dead centre, the upper guide face of a horizontal machine is"
        " loaded; driven machines therefore turn the other way than driving ones, which loads the lower one"
    ),
}
SUPPLIED = {
    "power": words("Leistungen|powers"),
    "indicated_power": words("Leistungen|powers"),
    "mean_pressure": words("mittlere Drücke|mean pressures"),
    "mean_pressure_kpa": words("mittlere Drücke|mean pressures"),
}
CYLINDERS = {
    "cylinder": words("Zylinder {number}: |Cylinder {number}: "),
    "stroke": words("Hub|stroke"),
    "lag": words("um {angle} hinter Zylinder {number}|{angle} behind cylinder {number}"),
    "driven": words(
        "Die Welle treibt den Kolben von Zylinder {numbers}: $T$ zählt in der Drehrichtung, Arbeit als"
        " abgegeben; dort sind das mittlere $T$ und die Arbeit negativ"
        "|The shaft drives the piston of cylinder {numbers}: $T$ counts as the crank turns, work as"
        " delivered; there the mean $T$ and the work are negative"
    ),
    "single": words("einfachwirkend|single-acting"),
    "double": words("doppeltwirkend|double-acting"),
    "count": words("{count} Zylinder|{count} cylinders"),
    "one": words("1 Zylinder|1 cylinder"),
}
OF_FIRST = words(
    "; $Q$, $r$ und $φ$ des zuerst genannten Zylinders, auf die alle Kräfte und Momente bezogen sind"
    "|; $Q$, $r$ and $φ$ of the cylinder named first, which all forces and moments are referred to"
)
OF_SEVERAL = words("der Maschine mit {count} Zylindern|of the engine of {count} cylinders")
OF_ONE = words("der Maschine mit einem Zylinder|of the engine of one cylinder")
OF_SPEED = {
    "root": words("$v/v_1 = sqrt(1 + 2 W/(m_1 v_1^2))$"),
    "first_order": words(
        "$v/v_1 = 1 + W/(m_1 v_1^2)$, erste Ordnung nach Weisbach"
        "|$v/v_1 = 1 + W/(m_1 v_1^2)$, to first order, by Weisbach"
    ),
    "square_law": words(
        "$J ω (d ω)/(d φ) = (T - P ω^2/Ω^2) r$ im Beharrungszustand, $Ω^2$ Mittel von $ω^2$ über den Winkel"
        "|$J ω (d ω)/(d φ) = (T - P ω^2/Ω^2) r$ in steady state, $Ω^2$ the mean of $ω^2$ over the angle"
    ),
    "letters": words(
        "$v_1$ Kurbelgeschwindigkeit im inneren Totpunkt, $m_1 = J/r^2$ Schwungmasse {at_radius},"
        " $P$ mittlere Umfangskraft"
        "|$v_1$ crank-pin velocity at the inner dead centre, $m_1 = J/r^2$ flywheel mass {at_radius},"
        " $P$ mean tangential force"
    ),
    "masses": words(
        "$1/2 (J + J_φ) ω^2 = 1/2 (J + J_0) ω_1^2 + W_p$; $J$ mit allem, was gleichförmig umläuft, $J_φ$ der"
        " übrigen bewegten Massen beim Winkel $φ$, $J_0$ im inneren Totpunkt, $W_p$ Überschussarbeit des"
        " Kolbendruckes allein"
        "|$1/2 (J + J_φ) ω^2 = 1/2 (J + J_0) ω_1^2 + W_p$; $J$ with all that turns evenly, $J_φ$ of the other"
        " moving masses at the angle $φ$, $J_0$ at the inner dead centre, $W_p$ excess work of the pressure"
        " on the piston alone"
    ),
    "even": words(
        "$T$ und $W$ mit dem Moment der Massen bei gleichförmiger Drehung; flywheel druckt $J_δ$, das ein $δ$"
        " bei wahrer Geschwindigkeit hält"
        "|$T$ and $W$ with the torque of the masses at uniform rotation; flywheel prints $J_δ$, which keeps a"
        " $δ$ at the true speed"
    ),
    "mean": words(
        '$n$ gegeben als Mittel $1/2 (n_"max" + n_"min")$|$n$ given as the mean $1/2 (n_"max" + n_"min")$'
    ),
    "constant": words(
        "Widerstandsmoment gleichbleibend (--resistance)|constant resisting torque (--resistance)"
    ),
    "square": words(
        "Widerstandsmoment wie das Quadrat der Geschwindigkeit|resisting torque as the square of the speed"
    ),
    "constant_driven": words(
        "Antriebsmoment gleichbleibend (--resistance)|constant driving torque (--resistance)"
    ),
    "delta_mean": words('$δ_m = (v_"max" - v_"min")/v_m$, $v_m = 1/2 (v_"max" + v_"min")$'),
    "delta_first": words(
        '$δ_1 = (v_"max" - v_"min")/v_1$, nach Weisbach|$δ_1 = (v_"max" - v_"min")/v_1$, by Weisbach'
    ),
}
HARMONICS: Mapping[str, Words] = {
    "member": words("Zylinder|Cylinder"),
    "one": words("Zylinder {number}|Cylinder {number}"),
    "whole": words("alle Zylinder|All cylinders"),
    "sum": words(
        "$T = P + Σ (a_k cos k φ + b_k sin k φ) = P + Σ c_k cos(k φ + ψ_k)$, $P$ mittlere Tangentialkraft;"
        " $φ$ {begin}"
        "|$T = P + Σ (a_k cos k φ + b_k sin k φ) = P + Σ c_k cos(k φ + ψ_k)$, $P$ mean tangential force;"
        " $φ$ {begin}"
    ),
    "dead_centre": words(
        "vom inneren Totpunkt der ersten Kurbel|from the inner dead centre of the first crank"
    ),
    "slide": words("der ersten Kurbel von der Schubrichtung|of the first crank from the slide direction"),
    "star": words(
        "$s_k$ Betrag von $Σ e^(i k α)$, $α$ Winkel, um den eine Kurbel der ersten folgt"
        "|$s_k$ magnitude of $Σ e^(i k α)$, $α$ angle by which a crank follows the first"
    ),
    "zero": words("0 ohne Dezimalen ist genau 0|0 without decimals is exactly 0"),
}
ROD_LOAD = {
    "end": words("Stelle|Place"),
    "directions": words(
        "$S$ positiv als Druck, negativ als Zug; im Totpunkt gelten die Werte davor und danach"
        "|$S$ positive as a thrust, negative as a pull; at a dead centre the values before and after it count"
    ),
    "reversal": words(
        "Richtungswechsel: Kurbelwinkel, über den die Last das Vorzeichen hat, das sie seltener hat;"
        " API 618 verlangt ihn am Kreuzkopfzapfen, längs der Führung, über mindestens 15° und mit 3 %"
        "|reversal: the crank angle over which the load has the sign that it has over fewer degrees;"
        " API 618 asks at the crosshead pin, along the slide, for at least 15° and 3 %"
    ),
    "first": words("die Stange der ersten Kurbel|the rod of the first crank"),
    "masses": words(
        ", von Druck und hin- und hergehenden Massen ohne die Stange"
        "|, of pressure and reciprocating masses without the rod"
    ),
}
PRESSED: Mapping[str, Words] = {
    "slide": words(
        "$φ$ von der Schubrichtung, der innere Totpunkt bei $φ_i = {inner}°$"
        "|$φ$ from the slide direction, the inner dead centre at $φ_i = {inner}°$"
    ),
    "out": words("Hingang|Outstroke"),
    "return": words("Rückgang|Return"),
    "numbered": words("{number}. Hub, {stroke}|Stroke {number}, {stroke}"),
    "pressures": words("Drücke|pressures"),
    "driven": words(
        "Arbeitsmaschine: die Welle treibt den Kolben, ein negatives $p$ hemmt ihn"
        "|driven machine: the shaft drives the piston, a negative $p$ resists it"
    ),
    "stroke": words("Hub|Stroke"),
    "share": words("Kolbenweg in Teilen des Hubes|Piston path in strokes"),
    "signs": words(
        "$p$ Überdruck auf den Kolben, $q = m a/A$ Beschleunigungsdruck der hin- und hergehenden Masse $m$"
        " bei der Beschleunigung $a$ auf die Kolbenfläche $A$, $p - q$ bleibt für das Gestänge; positiv in"
        " der Richtung des Hubes"
        "|$p$ pressure on the piston less that on its other face, $q = m a/A$ what the reciprocating mass $m$"
        " takes of it for the acceleration $a$, over the piston area $A$, $p - q$ what is left for the rod;"
        " positive in the direction of the stroke"
    ),
    "mass": words("$m = {mass}${rod}, $d = {bore}$|$m = {mass}${rod}, $d = {bore}$"),
    "rod": words(
        " mit dem Teil der Schubstange am Kreuzkopfzapfen| with the rod's share at the crosshead pin"
    ),
}
# What the pressure is that mean pressures count in, by the load.
COUNTED_IN = {
    STEAM: words("Dampfdruck vor der Absperrung|steam pressure before cut-off"),
    COMPRESSOR: words("Saugdruck|suction pressure"),
    GAS: words("Saugdruck|suction pressure"),
    PUMP: words("Förderdruck weniger Saugdruck|delivery pressure less suction pressure"),
    CARD: words("der größte Druck des Diagramms|the greatest pressure of the card"),
}
POWER_TEXTS = {
    "power": words(
        "$N_i = z k p_i A S n$, $A = {area}$; Zylinder $z = {cylinders}$, wirksame Hübe eines Zylinders in"
        " der Umdrehung $k = {strokes}$"
        "|$N_i = z k p_i A S n$, $A = {area}$; cylinders $z = {cylinders}$, working strokes of a cylinder"
        " in a turn $k = {strokes}$"
    ),
    "factor": words(
        "$p_i = φ_d p_m$, Völligkeitsgrad des Diagramms $φ_d = {factor}$"
        "|$p_i = φ_d p_m$, diagram factor $φ_d = {factor}$"
    ),
    "factor_found": words(
        "$p_i = φ_d p_m$, Völligkeitsgrad des Diagramms $φ_d$ aus der Leistung"
        "|$p_i = φ_d p_m$, diagram factor $φ_d$ from the power"
    ),
    "warm": words('Ansaugtemperatur $T_1 = {temperature} "K"$|suction temperature $T_1 = {temperature} "K"$'),
    "free": words(
        'freie Luft: ${pressure}$, ${temperature} "K"$|free air: ${pressure}$, ${temperature} "K"$'
    ),
    "stages": words(
        "{stages} Stufen mit vollkommener Zwischenkühlung beim besten Zwischendruck $p_z$, ihre mittleren"
        " Drücke zusammen auf den Kolben der ersten bezogen; alle mit ihrem Hub und ihrem schädlichen Raum"
        "|{stages} stages with perfect intercooling at the best intermediate pressure $p_z$, their mean"
        " pressures together on the piston of the first; all with its stroke and its clearance"
    ),
    "given_stages": words(
        "{stages} Stufen, dazwischen auf {cooled} gekühlt, ihre mittleren Drücke zusammen auf den Kolben der"
        " ersten bezogen; alle mit ihrem Hub und ihrem schädlichen Raum"
        "|{stages} stages, cooled to {cooled} between them, their mean pressures together on the piston of"
        " the first; all with its stroke and its clearance"
    ),
    "as_sucked": words("die Ansaugtemperatur|the temperature of suction"),
    "further_stages": words(
        "hinter jeder weiteren Stufe der Druck $Π^(1/{stages})$ mal so hoch, ihr Kolben um so viel kleiner"
        "|behind each further stage the pressure is $Π^(1/{stages})$ times as high, and its piston's area as"
        " much smaller"
    ),
    "compound": words(
        "Verbundmaschine gleicher Hübe ohne Druckabfall zwischen den Zylindern: $p_i$ und $d$ des"
        " Niederdruckzylinders, in dem das ganze Diagramm steht, $p_a = p/ε_h$, Arbeiten wie $ln ε_h$ zu"
        " $1 + ln(ε/ε_h) - ε p_b/p$"
        "|Compound engine of equal strokes without a fall of pressure between its cylinders: $p_i$ and $d$ of"
        " the low-pressure one, in which the whole diagram stands, $p_a = p/ε_h$, works as $ln ε_h$ to"
        " $1 + ln(ε/ε_h) - ε p_b/p$"
    ),
    "ideal_air": words(
        '$N_"is" = p_1 V ln Π$, $N_"ad" = γ/(γ - 1) p_1 V (Π^((γ - 1)/γ) - 1)$ in einer Stufe, $γ = 1.4$'
        '|$N_"is" = p_1 V ln Π$, $N_"ad" = γ/(γ - 1) p_1 V (Π^((γ - 1)/γ) - 1)$ in one stage, $γ = 1.4$'
    ),
    "heats": words(
        "Wärmen mit $c_p = 3.5 R$: abgegeben wird von der Arbeit, was die Luft nicht wärmer macht; der Kühler"
        " nimmt das übrige"
        "|heats with $c_p = 3.5 R$: what of the work does not make the air warmer is given off; the cooler"
        " takes the rest"
    ),
    "sought": words(
        "{symbol}: alle Werte {bounds}, mit denen das Gegebene gilt"
        "|{symbol}: all values {bounds} with which what is given holds"
    ),
    "efficiency": words(
        "$N_e = η N_i$, mechanischer Wirkungsgrad $η = {efficiency}$"
        "|$N_e = η N_i$, mechanical efficiency $η = {efficiency}$"
    ),
    "efficiency_found": words(
        "mechanischer Wirkungsgrad $η$ aus beiden Leistungen|mechanical efficiency $η$ from both powers"
    ),
    "burnt": words("$η_i = N_i/(B H)$|$η_i = N_i/(B H)$"),
    "burnt_at_shaft": words("$η_e = N_e/(B H)$, $η_i = N_i/(B H)$|$η_e = N_e/(B H)$, $η_i = N_i/(B H)$"),
    "air": words('Luft: $R = 287 "J/(kg K)"$|air: $R = 287 "J/(kg K)"$'),
    "supplied": words(
        "Die Welle treibt den Kolben; Drücke und Leistungen positiv, als zugeführt"
        "|The shaft drives the piston; pressures and powers positive, as supplied"
    ),
    "efficiency_supplied": words(
        "$N_e = N_i/η$, mechanischer Wirkungsgrad $η = {efficiency}$"
        "|$N_e = N_i/η$, mechanical efficiency $η = {efficiency}$"
    ),
    "ends": words(
        "$p_i$ am Deckel ${cover}$, an der Kurbel ${crank}$, im Mittel nach den Flächen"
        "|$p_i$ at the cover ${cover}$, at the crank ${crank}$, the mean by their areas"
    ),
    "given": words("Gegeben: {given}|Given: {given}"),
    "steam": words(
        "Dampf eines wirksamen Hubes {volume} $V_h/v$, $v = {specific}$ vor der Absperrung"
        "|Steam of a working stroke {volume} $V_h/v$, $v = {specific}$ before cut-off"
    ),
    "kept": words(
        "; der schädliche Raum enthält noch Dampf vom Gegendruck $p_b$"
        "|; the clearance still keeps steam of the back pressure $p_b$"
    ),
    "clearance": words(
        "schädlicher Raum $κ = {clearance}$ des Hubraumes|clearance $κ = {clearance}$ of the swept volume"
    ),
    "back": words("Gegendruck $p_b = {back} p$|back pressure $p_b = {back} p$"),
    "ideal": words("ideales Diagramm (--diagram-factor)|ideal card (--diagram-factor)"),
    "card": words(
        "Druck aus dem Diagramm; gedruckt sind nur so viele Stellen, wie seine Punkte tragen"
        "|pressure from the card; only as many digits as its points support are printed"
    ),
}
