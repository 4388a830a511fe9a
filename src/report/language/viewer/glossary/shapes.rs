//! What the quantities of the shapes, their patterns and their motions mean.

use crate::report::language::Text;

/// Their keys in a log, with what they mean.
pub(super) const ROWS: &[(&str, [Text; 2])] = &[
    ("ellipsoid.center", ["centre of the ellipsoid", "centro del elipsoide"]),
    (
        "ellipsoid.row_1",
        [
            "first row of the linear map that makes it a sphere",
            "primera fila de la aplicación lineal que lo convierte en esfera",
        ],
    ),
    ("ellipsoid.row_2", ["second row of this map", "segunda fila de esa aplicación"]),
    ("ellipsoid.row_3", ["third row of this map", "tercera fila de esa aplicación"]),
    (
        "ellipsoid.radius_squared",
        ["square of its greatest radius, that of the sphere", "cuadrado de su radio mayor, que es el de la esfera"],
    ),
    ("ellipsoid.origin", ["from the centre to the origin of the ray", "del centro al origen del rayo"]),
    ("ellipsoid.origin_1", ["coordinate 1 of the mapped origin", "coordenada 1 del origen transformado"]),
    ("ellipsoid.origin_2", ["coordinate 2 of the mapped origin", "coordenada 2 del origen transformado"]),
    ("ellipsoid.origin_3", ["coordinate 3 of the mapped origin", "coordenada 3 del origen transformado"]),
    ("ellipsoid.direction_1", ["coordinate 1 of the mapped direction", "coordenada 1 de la dirección transformada"]),
    ("ellipsoid.direction_2", ["coordinate 2 of the mapped direction", "coordenada 2 de la dirección transformada"]),
    ("ellipsoid.direction_3", ["coordinate 3 of the mapped direction", "coordenada 3 de la dirección transformada"]),
    (
        "ellipsoid.a",
        ["coefficient of t² in the quadratic equation", "coeficiente de t² en la ecuación de segundo grado"],
    ),
    (
        "ellipsoid.b",
        [
            "half the coefficient of t; positive if the middle of the chord lies behind",
            "mitad del coeficiente de t; positiva si el centro de la cuerda queda detrás",
        ],
    ),
    (
        "ellipsoid.c",
        ["constant term; positive if the origin is outside", "término independiente; positivo si el origen está fuera"],
    ),
    (
        "ellipsoid.discriminant",
        ["discriminant; negative if the ray passes beside it", "discriminante; negativo si el rayo pasa de largo"],
    ),
    ("ellipsoid.t", ["distance along the ray to the ellipsoid", "distancia al elipsoide a lo largo del rayo"]),
    (
        "ellipsoid.point",
        [
            "from the centre to the point, before it is put onto the ellipsoid",
            "del centro al punto, antes de llevarlo al elipsoide",
        ],
    ),
    ("ellipsoid.point_1", ["coordinate 1 of the mapped point", "coordenada 1 del punto transformado"]),
    ("ellipsoid.point_2", ["coordinate 2 of the mapped point", "coordenada 2 del punto transformado"]),
    ("ellipsoid.point_3", ["coordinate 3 of the mapped point", "coordenada 3 del punto transformado"]),
    (
        "ellipsoid.offset",
        [
            "value of the equation at the point, 0 but for rounding; positive outside",
            "valor de la ecuación en el punto, 0 salvo redondeo; positivo fuera",
        ],
    ),
    ("ellipsoid.gradient", ["outward normal, before it is normalised", "normal exterior, antes de normalizar"]),
    ("quadratic.q", ["one root times a, added without cancelling", "una raíz por a, sumada sin cancelación"]),
    (
        "quadratic.t_1",
        [
            "root of the quadratic equation, the one farther from 0",
            "raíz de la ecuación de segundo grado, la más alejada de 0",
        ],
    ),
    ("quadratic.t_2", ["the other root, the one nearer to 0", "la otra raíz, la más cercana a 0"]),
    ("triangle.a", ["corner A of the triangle", "vértice A del triángulo"]),
    ("triangle.b", ["corner B of the triangle", "vértice B del triángulo"]),
    ("triangle.c", ["corner C of the triangle", "vértice C del triángulo"]),
    (
        "triangle.normal",
        [
            "normal of the triangle, as long as twice its area",
            "normal del triángulo, tan larga como el doble de su área",
        ],
    ),
    ("triangle.unit_normal", ["unit normal of the triangle", "normal unitaria del triángulo"]),
    (
        "triangle.edge_a",
        [
            "its sign says on which side of the edge BC the ray passes; inside if all three have one sign",
            "su signo dice a qué lado de la arista BC pasa el rayo; por dentro si los tres tienen el mismo",
        ],
    ),
    ("triangle.edge_b", ["its sign: on which side of CA the ray passes", "su signo: a qué lado de CA pasa el rayo"]),
    ("triangle.edge_c", ["its sign: on which side of AB the ray passes", "su signo: a qué lado de AB pasa el rayo"]),
    (
        "triangle.edges_exact",
        [
            "E_a, E_b, E_c without rounding, where it left a sign in doubt",
            "E_a, E_b, E_c sin redondeo, donde este dejaba un signo en duda",
        ],
    ),
    ("triangle.v_d", ["normal · direction; 0 if the ray is parallel", "normal · dirección; 0 si el rayo es paralelo"]),
    (
        "triangle.v_o",
        [
            "distance of the origin from the plane times |N_t|; negative in front of it",
            "distancia del origen al plano por |N_t|; negativa delante de él",
        ],
    ),
    (
        "triangle.t",
        ["distance along the ray to the plane of the triangle", "distancia al plano del triángulo a lo largo del rayo"],
    ),
    ("triangle.t_near", ["distance at which the ray enters its box", "distancia a la que el rayo entra en su caja"]),
    ("triangle.t_far", ["distance at which the ray leaves its box", "distancia a la que el rayo sale de su caja"]),
    ("triangle.normal_a", ["normal at the corner A", "normal en el vértice A"]),
    ("triangle.normal_b", ["normal at the corner B", "normal en el vértice B"]),
    ("triangle.normal_c", ["normal at the corner C", "normal en el vértice C"]),
    ("triangle.weight_a", ["barycentric weight of the normal at A", "peso baricéntrico de la normal en A"]),
    ("triangle.weight_b", ["barycentric weight of the normal at B", "peso baricéntrico de la normal en B"]),
    ("triangle.weight_c", ["barycentric weight of the normal at C", "peso baricéntrico de la normal en C"]),
    (
        "triangle.mean_normal",
        [
            "weighted mean of the normals at the corners, before it is normalised",
            "media ponderada de las normales en los vértices, antes de normalizar",
        ],
    ),
    ("polygon.corner", ["first corner of the polygon", "primer vértice del polígono"]),
    (
        "polygon.normal",
        ["normal of the polygon, as long as twice its area", "normal del polígono, tan larga como el doble de su área"],
    ),
    ("polygon.unit_normal", ["unit normal of the polygon", "normal unitaria del polígono"]),
    ("polygon.v_d", ["normal · direction; 0 if the ray is parallel", "normal · dirección; 0 si el rayo es paralelo"]),
    (
        "polygon.v_o",
        [
            "distance of the origin from the plane times |N_q|; negative in front of it",
            "distancia del origen al plano por |N_q|; negativa delante de él",
        ],
    ),
    (
        "polygon.t",
        ["distance along the ray to the plane of the polygon", "distancia al plano del polígono a lo largo del rayo"],
    ),
    ("polygon.t_near", ["distance at which the ray enters its box", "distancia a la que el rayo entra en su caja"]),
    ("polygon.t_far", ["distance at which the ray leaves its box", "distancia a la que el rayo sale de su caja"]),
    (
        "polygon.crossings",
        [
            "how many edges a half plane from the ray crosses; odd if the ray passes inside",
            "cuántas aristas corta un semiplano que parte del rayo; impar si el rayo pasa por dentro",
        ],
    ),
    ("box.min", ["corner of the box with the least coordinates", "vértice de la caja con las coordenadas menores"]),
    ("box.max", ["corner of the box with the greatest coordinates", "vértice de la caja con las coordenadas mayores"]),
    ("box.face_normal", ["unit normal of the face, outward", "normal unitaria de la cara, hacia fuera"]),
    (
        "box.to_min",
        ["distances along the ray to the faces at b_min", "distancias a las caras en b_min a lo largo del rayo"],
    ),
    (
        "box.to_max",
        ["distances along the ray to the faces at b_max", "distancias a las caras en b_max a lo largo del rayo"],
    ),
    (
        "box.entry",
        [
            "distance at which the ray enters the box; above t_out if it passes beside it",
            "distancia a la que el rayo entra en la caja; mayor que t_out si pasa de largo",
        ],
    ),
    (
        "box.exit",
        [
            "distance at which the ray leaves the box; negative if the box lies behind",
            "distancia a la que el rayo sale de la caja; negativa si la caja queda detrás",
        ],
    ),
    ("box.t", ["distance along the ray to the box", "distancia a la caja a lo largo del rayo"]),
    ("axis.base", ["centre of the base", "centro de la base"]),
    ("axis.apex", ["centre of the other end, or tip of a cone", "centro del otro extremo, o vértice de un cono"]),
    ("axis.direction", ["unit vector from the base to the other end", "vector unitario de la base al otro extremo"]),
    ("axis.length", ["distance between both ends", "distancia entre los dos extremos"]),
    (
        "axis.origin",
        [
            "from the base to the origin of the ray, or of a cone to its point at t_0",
            "de la base al origen del rayo, o en un cono a su punto en t_0",
        ],
    ),
    (
        "axis.origin_along",
        [
            "how far along the axis that point lies, negative before the base",
            "dónde queda ese punto a lo largo del eje, negativo antes de la base",
        ],
    ),
    ("axis.origin_across", ["its part across the axis, turned by 90°", "su parte perpendicular al eje, girada 90°"]),
    (
        "axis.ray_along",
        [
            "cosine between ray and axis; 0 if the ray runs parallel to the ends",
            "coseno entre el rayo y el eje; 0 si el rayo es paralelo a los extremos",
        ],
    ),
    (
        "axis.ray_across",
        [
            "part of the direction across the axis, turned by 90°",
            "parte de la dirección perpendicular al eje, girada 90°",
        ],
    ),
    (
        "axis.t_base",
        [
            "distance along the ray to the plane of the base, of a cone from t_0 on",
            "distancia al plano de la base a lo largo del rayo, en un cono desde t_0",
        ],
    ),
    (
        "axis.t_apex",
        [
            "distance along the ray to the plane of the other end, of a cone from t_0 on",
            "distancia al plano del otro extremo a lo largo del rayo, en un cono desde t_0",
        ],
    ),
    (
        "axis.point",
        [
            "from the base to the point, before it is put onto the surface",
            "de la base al punto, antes de llevarlo a la superficie",
        ],
    ),
    (
        "axis.point_along",
        [
            "how far along the axis the point lies, from the base",
            "dónde queda el punto a lo largo del eje, desde la base",
        ],
    ),
    ("axis.point_across", ["from the axis to the point, at a right angle", "del eje al punto, en ángulo recto"]),
    ("cylinder.radius", ["radius of the cylinder", "radio del cilindro"]),
    ("cylinder.radius_squared", ["its radius squared", "su radio al cuadrado"]),
    (
        "cylinder.a",
        [
            "coefficient of t²; 0 if the ray is parallel to the axis",
            "coeficiente de t²; 0 si el rayo es paralelo al eje",
        ],
    ),
    (
        "cylinder.b",
        [
            "half the coefficient of t; positive if the middle of the chord lies behind",
            "mitad del coeficiente de t; positiva si el centro de la cuerda queda detrás",
        ],
    ),
    (
        "cylinder.c",
        [
            "constant term; negative if the origin is less than the radius away from the axis",
            "término independiente; negativo si el origen dista del eje menos que el radio",
        ],
    ),
    (
        "cylinder.discriminant",
        ["discriminant; negative if the ray passes beside it", "discriminante; negativo si el rayo pasa de largo"],
    ),
    ("cylinder.t", ["distance along the ray to the cylinder", "distancia al cilindro a lo largo del rayo"]),
    ("cone.base_radius", ["radius at the base", "radio en la base"]),
    (
        "cone.slope",
        [
            "growth of the radius per length of the axis; negative if the cone narrows",
            "crecimiento del radio por longitud del eje; negativo si el cono se estrecha",
        ],
    ),
    (
        "cone.t_0",
        [
            "distance along the ray to its point nearest to the base, from which roots count",
            "distancia a lo largo del rayo a su punto más cercano a la base, desde el que se cuentan las raíces",
        ],
    ),
    (
        "cone.origin_radius",
        [
            "radius of the cone level with that point; negative beyond the tip",
            "radio del cono a la altura de ese punto; negativo más allá del vértice",
        ],
    ),
    ("cone.ray_radius", ["growth of this radius along the ray", "crecimiento de ese radio a lo largo del rayo"]),
    (
        "cone.a",
        [
            "coefficient of t²; negative if the line meets both halves of the double cone",
            "coeficiente de t²; negativo si la recta corta las dos mitades del cono doble",
        ],
    ),
    ("cone.b", ["half the coefficient of t", "mitad del coeficiente de t"]),
    (
        "cone.c",
        ["constant term; positive outside the double cone", "término independiente; positivo fuera del cono doble"],
    ),
    (
        "cone.discriminant",
        ["discriminant; negative if the ray passes beside it", "discriminante; negativo si el rayo pasa de largo"],
    ),
    ("cone.t", ["distance along the ray to the cone", "distancia al cono a lo largo del rayo"]),
    (
        "cone.offset",
        [
            "distance of the point from the axis, less the radius there: 0 but for rounding",
            "distancia del punto al eje, menos el radio allí: 0 salvo redondeo",
        ],
    ),
    ("cone.gradient", ["outward normal, before it is normalised", "normal exterior, antes de normalizar"]),
    ("disk.center", ["centre of the disk", "centro del disco"]),
    ("disk.normal", ["normal of the disk as given", "normal dada del disco"]),
    ("disk.unit_normal", ["unit normal of the disk", "normal unitaria del disco"]),
    ("disk.radius", ["radius of the disk", "radio del disco"]),
    ("disk.v_d", ["normal · direction; 0 if the ray is parallel", "normal · dirección; 0 si el rayo es paralelo"]),
    (
        "disk.v_o",
        [
            "distance of the origin from the plane times |N_d|; negative in front of it",
            "distancia del origen al plano por |N_d|; negativa delante de él",
        ],
    ),
    ("disk.t", ["distance along the ray to the plane of the disk", "distancia al plano del disco a lo largo del rayo"]),
    (
        "disk.distance_squared",
        [
            "square of the point's distance from the centre; above r_d² the ray passes beside the disk",
            "cuadrado de la distancia del punto al centro; mayor que r_d² si el rayo pasa de largo",
        ],
    ),
    ("pattern.a", ["colour of the even cubes of the pattern", "color de los cubos pares del patrón"]),
    ("pattern.b", ["colour of the odd cubes of the pattern", "color de los cubos impares del patrón"]),
    ("pattern.size", ["side of a cube of the pattern", "lado de un cubo del patrón"]),
    (
        "pattern.axes",
        [
            "1 for the axes that count; a flat surface leaves out the one nearest to its normal",
            "1 en los ejes que cuentan; una superficie plana omite el más próximo a su normal",
        ],
    ),
    ("pattern.cell", ["number of the point's cube along each axis", "número del cubo del punto en cada eje"]),
    ("pattern.sum", ["sum of these numbers along the axes that count", "suma de esos números en los ejes que cuentan"]),
    ("pattern.parity", ["parity of the sum: 0 even, 1 odd", "paridad de la suma: 0 par, 1 impar"]),
    ("pattern.color", ["colour of the pattern at the point", "color del patrón en el punto"]),
    ("motion.translation", ["velocity of the object", "velocidad del objeto"]),
    (
        "motion.shift",
        ["how far the object has moved by this time", "cuánto se ha desplazado el objeto hasta este instante"],
    ),
    ("motion.axis", ["unit vector along the axis of the turn", "vector unitario del eje de giro"]),
    ("motion.point", ["a point on the axis of the turn", "un punto del eje de giro"]),
    (
        "motion.degrees",
        [
            "angle by which the object turns in a unit of time, in degrees",
            "ángulo que gira el objeto por unidad de tiempo, en grados",
        ],
    ),
    (
        "motion.angle",
        [
            "angle by which it has turned by this time, in degrees",
            "ángulo que ha girado hasta este instante, en grados",
        ],
    ),
    ("motion.cos", ["cosine of this angle", "coseno de ese ángulo"]),
    ("motion.sin", ["sine of this angle", "seno de ese ángulo"]),
    ("motion.arm", ["from p_M on the axis to the point that is turned", "de p_M, en el eje, al punto que se gira"]),
    (
        "motion.hit_point",
        ["point of intersection in the object's own frame", "punto de intersección en las coordenadas del objeto"],
    ),
    (
        "motion.hit_normal",
        ["unit normal there, in the object's own frame", "normal unitaria en él, en las coordenadas del objeto"],
    ),
    (
        "motion.geometric_normal",
        ["normal of the surface itself in this frame", "normal de la propia superficie en esas coordenadas"],
    ),
    ("pattern.point", ["the point in the object's own frame", "el punto en las coordenadas del objeto"]),
];
