//! What the quantities of sampling and of distributed effects mean.

use crate::report::language::Text;

/// Their keys in a log, with what they mean.
pub(super) const ROWS: &[(&str, [Text; 2])] = &[
    ("sample.column", ["column of the stratum in its row, from 0", "columna del estrato en su fila, desde 0"]),
    (
        "sample.jitter_x",
        [
            "random place in the stratum, to the right, from 0 to 1",
            "lugar aleatorio en el estrato, hacia la derecha, de 0 a 1",
        ],
    ),
    ("sample.across", ["number of strata in this row", "número de estratos de esa fila"]),
    ("sample.above", ["number of strata in the rows above", "número de estratos de las filas superiores"]),
    (
        "sample.jitter_y",
        ["random place in the stratum, downward, from 0 to 1", "lugar aleatorio en el estrato, hacia abajo, de 0 a 1"],
    ),
    ("sample.count", ["number of all strata", "número total de estratos"]),
    (
        "pixel.left",
        ["left side of the pixel, in columns of the picture", "borde izquierdo del píxel, en columnas de la imagen"],
    ),
    (
        "pixel.top",
        ["upper side of the pixel, in rows of the picture", "borde superior del píxel, en filas de la imagen"],
    ),
    (
        "cell.color_1",
        ["colour at the upper left corner of the cell", "color en la esquina superior izquierda de la celda"],
    ),
    ("cell.color_2", ["colour at its upper right corner", "color en su esquina superior derecha"]),
    ("cell.color_3", ["colour at its lower left corner", "color en su esquina inferior izquierda"]),
    ("cell.color_4", ["colour at its lower right corner", "color en su esquina inferior derecha"]),
    (
        "cell.threshold",
        [
            "threshold for the differences of colours, as a part of white",
            "umbral de las diferencias de color, como parte del blanco",
        ],
    ),
    ("cell.limit", ["the same threshold as an intensity", "el mismo umbral como intensidad"]),
    (
        "cell.difference",
        [
            "greatest difference of the colours at the corners; above Δ_max the cell is subdivided",
            "mayor diferencia de los colores de las esquinas; si supera Δ_max, la celda se subdivide",
        ],
    ),
    ("cell.area", ["area of the cell, as a part of the pixel", "área de la celda, como parte del píxel"]),
    ("statistical.mean", ["mean of the samples so far", "media de las muestras hasta aquí"]),
    ("statistical.standard_error", ["standard error of this mean", "error estándar de esa media"]),
    (
        "statistical.degrees_of_freedom",
        ["degrees of freedom of the standard error", "grados de libertad del error estándar"],
    ),
    ("statistical.confidence", ["confidence that the interval is to have", "confianza que debe tener el intervalo"]),
    (
        "statistical.t_quantile",
        [
            "quantile of Student's distribution: the half-width in standard errors",
            "cuantil de la distribución de Student: la semiamplitud en errores estándar",
        ],
    ),
    (
        "statistical.half_width",
        ["half-width of the confidence interval of the mean", "semiamplitud del intervalo de confianza de la media"],
    ),
    ("statistical.widest", ["greatest half-width of all channels", "mayor semiamplitud de todos los canales"]),
    (
        "statistical.tolerance",
        [
            "greatest half-width accepted, as a part of white; of samples that agree, the part that they may miss",
            "mayor semiamplitud que se acepta, como parte del blanco; si las muestras coinciden, lo que pueden no ver",
        ],
    ),
    ("statistical.alike_needed", ["how many samples that agree are enough", "cuántas muestras que coinciden bastan"]),
    (
        "statistical.limit",
        ["greatest half-width that is accepted, as an intensity", "mayor semiamplitud que se acepta, como intensidad"],
    ),
    ("output.white", ["intensity that the picture shows as white", "intensidad que la imagen muestra como blanco"]),
    (
        "guided.variance",
        [
            "mean variance of the first samples of the pixels around, as a part of the square of white",
            "varianza media de las primeras muestras de los píxeles de alrededor, como parte del cuadrado del blanco",
        ],
    ),
    (
        "guided.contrast",
        [
            "greatest difference of their means, as a part of white",
            "mayor diferencia de sus medias, como parte del blanco",
        ],
    ),
    (
        "guided.error",
        [
            "error of one sample to be expected from these two, as a part of white",
            "error que hacen esperar de una muestra, como parte del blanco",
        ],
    ),
    (
        "guided.tolerance",
        [
            "error for which one sample would be enough, as a part of white",
            "error con el que bastaría una muestra, como parte del blanco",
        ],
    ),
    (
        "guided.asked",
        [
            "how many samples the first samples of the pixels around ask for",
            "cuántas muestras piden las primeras muestras de los píxeles de alrededor",
        ],
    ),
    ("camera.position", ["the eye, centre of the lens", "el ojo, centro de la lente"]),
    (
        "lens.focus_distance",
        [
            "distance of the plane in focus, along the direction of view",
            "distancia del plano enfocado, a lo largo de la dirección de la vista",
        ],
    ),
    (
        "lens.focus",
        [
            "point of the plane in focus through which all rays of this place of the picture pass",
            "punto del plano enfocado por el que pasan todos los rayos de este lugar de la imagen",
        ],
    ),
    ("disc.x", ["first coordinate of a point of the unit disc", "primera coordenada de un punto del disco unidad"]),
    ("disc.y", ["its second coordinate", "su segunda coordenada"]),
    ("lens.radius", ["radius of the lens", "radio de la lente"]),
    ("shutter.open", ["time at which the shutter opens", "instante en que se abre el obturador"]),
    (
        "sample.time",
        [
            "random part of the time for which the shutter is open",
            "parte aleatoria del tiempo que el obturador está abierto",
        ],
    ),
    ("shutter.close", ["time at which the shutter closes", "instante en que se cierra el obturador"]),
    ("light.center", ["centre of the area light", "centro de la fuente extensa"]),
    (
        "light.edge_u",
        [
            "from the centre to the middle of a side, or to the rim of a disk",
            "del centro a la mitad de un lado, o al borde de un disco",
        ],
    ),
    (
        "light.edge_v",
        [
            "the same to the next side, or to the rim at a right angle",
            "lo mismo al lado contiguo, o al borde en ángulo recto",
        ],
    ),
    ("light.radius", ["radius of the sphere from which the light comes", "radio de la esfera de la que viene la luz"]),
    (
        "light.spread",
        [
            "how far the profile draws the point toward the centre; 1 without a profile",
            "cuánto acerca el perfil el punto al centro; 1 sin perfil",
        ],
    ),
    ("light.x", ["place on the light along e_u, from −1 to 1", "lugar en la fuente a lo largo de e_u, de −1 a 1"]),
    ("light.y", ["place on the light along e_v, from −1 to 1", "lugar en la fuente a lo largo de e_v, de −1 a 1"]),
    (
        "light.outward",
        [
            "unit vector from the centre of the sphere to the point of the light",
            "vector unitario del centro de la esfera al punto de la fuente",
        ],
    ),
    (
        "light.solid_angle",
        [
            "solid angle in which the light is seen from the point",
            "ángulo sólido en el que se ve la fuente desde el punto",
        ],
    ),
    (
        "light.profile_cosine",
        [
            "cosine by which the profile falls: 1 in the centre, 0 at the rim",
            "coseno según el que decae el perfil: 1 en el centro, 0 en el borde",
        ],
    ),
    (
        "light.profile_power",
        ["its exponent: the greater, the more the middle counts", "su exponente: cuanto mayor, más cuenta el centro"],
    ),
    ("light.profile_mean", ["mean of this power over the light", "media de esa potencia sobre la fuente"]),
    ("light.weight", ["weight of the shadow ray by the profile", "peso del rayo de sombra según el perfil"]),
    (
        "light.share",
        [
            "part of the mean over the light that this point of a rule has",
            "parte de la media sobre la fuente que tiene este punto de una regla",
        ],
    ),
    (
        "lobe.middle",
        [
            "axis of the lobe: the exact direction, reflected or transmitted",
            "eje del lóbulo: la dirección exacta, reflejada o transmitida",
        ],
    ),
    (
        "lobe.exponent",
        ["exponent of the lobe: the greater, the narrower", "exponente del lóbulo: cuanto mayor, más estrecho"],
    ),
    (
        "lobe.helper",
        [
            "the coordinate axis that is farthest from that of the lobe",
            "el eje de coordenadas más alejado del eje del lóbulo",
        ],
    ),
    ("lobe.axis_1", ["unit vector across the axis of the lobe", "vector unitario perpendicular al eje del lóbulo"]),
    ("lobe.axis_2", ["unit vector across both", "vector unitario perpendicular a ambos"]),
    ("lobe.x", ["component of the direction along u_z", "componente de la dirección según u_z"]),
    ("lobe.y", ["component of the direction along w_z", "componente de la dirección según w_z"]),
    (
        "lobe.z",
        ["cosine between the direction and the axis of the lobe", "coseno entre la dirección y el eje del lóbulo"],
    ),
    ("lobe.direction", ["random direction of the lobe", "dirección aleatoria del lóbulo"]),
    (
        "lobe.height",
        [
            "cosine between normal and direction; negative below the surface",
            "coseno entre la normal y la dirección; negativo por debajo de la superficie",
        ],
    ),
    ("lobe.color", ["intensity that the ray of the zone brings", "intensidad que trae el rayo de la zona"]),
    ("lobe.sum", ["sum over the zones so far", "suma de las zonas hasta aquí"]),
    ("lobe.kept", ["number of directions that aren't rejected", "número de direcciones que no se rechazan"]),
    (
        "lobe.mean",
        [
            "mean of the zones that are kept: the intensity that they bring",
            "media de las zonas aceptadas: la intensidad que traen",
        ],
    ),
];
