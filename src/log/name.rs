//! The named quantities: their keys in a log, their symbols and formulas on paper, and where the source text has them.
//!
//! One row a quantity. Adding a logged quantity is one row here and one `note` in the kernel that computes it. A formula
//! is written with the symbols of this same table (see [`super::formula`] for its grammar), and a test evaluates every
//! formula on the logged operands and must get the logged value. An event has its inputs in the order of this table, so that
//! their order in a file doesn't matter: a row stands behind those of the inputs that are given before it.

#[macro_use]
mod row;
#[macro_use]
mod effects;

use row::Row;

with_effects! { names! {
    // The camera and its ray. G is the direction of view, e_x and e_y point right and up in the picture.
    RayOrigin: "ray.origin", "", "O", "", "1.1.1";
    CameraDirection: "camera.direction", "", "G", "", "1.1.1";
    CameraUpAsGiven: "camera.up_as_given", "", "G_u", "", "1.1.1";
    CameraLength: "camera.length", "", "|G|", "√(G · G)", "1.1.1";
    CameraRight: "camera.right", "", "e_x", "(G×G_u)/|G×G_u|", "1.1.1";
    CameraUp: "camera.up", "", "e_y", "((G×G_u)×G)/|(G×G_u)×G|", "1.1.1";
    PixelColumn: "pixel.column", "", "col", "", "1.1.1";
    PixelMiddleColumn: "pixel.middle_column", "", "col_m", "", "1.1.1";
    PixelRow: "pixel.row", "", "row", "", "1.1.1";
    PixelMiddleRow: "pixel.middle_row", "", "row_m", "", "1.1.1";
    PixelSide: "pixel.side", "", "px", "2·tan(θ_v°/2)/n_v", "1.1.1";
    PixelX: "pixel.x", "", "x", "(col − col_m)·px", "1.1.1";
    PixelY: "pixel.y", "", "y", "(row_m − row)·px", "1.1.1";
    RayVector: "ray.vector", "", "D", "G + |G|·(x·e_x + y·e_y)", "1.1.1";
    RayLength: "ray.length", "", "|D|", "√(D · D)", "1.3 (1)";
    RayDirection: "ray.direction", "", "d", "D/|D|", "1.3 (1)";

    // Plane.
    PlaneNormal: "plane.normal", "", "N_p", "", "1.3 (2)";
    PlaneOffset: "plane.offset", "", "D_p", "", "1.3 (2)";
    PlaneVd: "plane.v_d", "", "V_d", "N_p · d", "1.3 (2)";
    PlaneVo: "plane.v_o", "", "V_o", "−(N_p · O + D_p)", "1.3 (2)";
    PlaneT: "plane.t", "", "t", "V_o/V_d", "1.3 (2)";
    // What was computed with more digits than f64 has, as were its operands: the formula on logged values gives it within a bound.
    PlaneTDoubled: "plane.t", "doubled", "t", "V_o/V_d", "1.3 (2)";

    // A ray that begins on a surface and goes through it.
    TouchT: "touch.t", "", "t", "0", "";

    // Sphere: the geometric method of the source text, and the robust one (Haines et al., Ray Tracing Gems, chapter 7).
    SphereCenter: "sphere.center", "", "S_c", "", "1.3 (5a)";
    SphereRadius: "sphere.radius", "", "r", "", "1.3 (5c)";
    SphereRadiusSquared: "sphere.radius_squared", "", "r²", "", "1.3 (5c)";
    SphereOc: "sphere.oc", "", "OC", "S_c − O", "1.3 (5a)";
    SphereL2oc: "sphere.l2_oc", "", "L2oc", "OC · OC", "1.3 (5a)";
    SphereTa: "sphere.t_a", "", "T_A", "OC · d", "1.3 (5b)";
    SphereT2a: "sphere.t2_a", "", "T2_A", "r² − L2oc + T_A²", "1.3 (5d)";
    SphereT2aRobust: "sphere.t2_a", "robust", "T2_A", "r² − |OC − T_A·d|²", "1.3 (5d)";
    SphereT: "sphere.t", "", "t", "T_A − √T2_A", "1.3 (5e)";
    SphereTFar: "sphere.t", "far", "t", "T_A + √T2_A", "1.3 (5e)";
    SphereTNearRobust: "sphere.t", "near_robust", "t", "(L2oc − r²)/(T_A + √T2_A)", "1.3 (5e)";
    SphereTFarRobust: "sphere.t", "far_robust", "t", "(r² − L2oc)/(√T2_A − T_A)", "1.3 (5e)";
    SphereT2aDoubled: "sphere.t2_a", "doubled", "T2_A", "r·r − |OC − T_A·d|²", "1.3 (5d)";
    SphereTDoubled: "sphere.t", "doubled", "t", "T_A − √T2_A", "1.3 (5e)";
    SphereFromCenter: "sphere.from_center", "", "q_s", "O − S_c + d·t", "1.3 (5f)";
    SphereTLeaving: "sphere.t", "leaving", "t", "2·T_A", "1.3 (5e)";

    // Ellipsoid. E_1, E_2 and E_3 are the rows of the linear map that makes it the sphere of its largest radius.
    EllipsoidCenter: "ellipsoid.center", "", "E_c", "", "1.1.1";
    EllipsoidRow1: "ellipsoid.row_1", "", "E_1", "", "1.1.1";
    EllipsoidRow2: "ellipsoid.row_2", "", "E_2", "", "1.1.1";
    EllipsoidRow3: "ellipsoid.row_3", "", "E_3", "", "1.1.1";
    EllipsoidRadiusSquared: "ellipsoid.radius_squared", "", "r²", "", "1.1.1";
    EllipsoidOrigin: "ellipsoid.origin", "", "o_e", "O − E_c", "1.1.1";
    EllipsoidOrigin1: "ellipsoid.origin_1", "", "o_1", "E_1 · o_e", "1.1.1";
    EllipsoidOrigin2: "ellipsoid.origin_2", "", "o_2", "E_2 · o_e", "1.1.1";
    EllipsoidOrigin3: "ellipsoid.origin_3", "", "o_3", "E_3 · o_e", "1.1.1";
    EllipsoidDirection1: "ellipsoid.direction_1", "", "d_1", "E_1 · d", "1.1.1";
    EllipsoidDirection2: "ellipsoid.direction_2", "", "d_2", "E_2 · d", "1.1.1";
    EllipsoidDirection3: "ellipsoid.direction_3", "", "d_3", "E_3 · d", "1.1.1";
    EllipsoidA: "ellipsoid.a", "", "a", "d_1² + d_2² + d_3²", "1.1.1";
    EllipsoidB: "ellipsoid.b", "", "b", "o_1·d_1 + o_2·d_2 + o_3·d_3", "1.1.1";
    EllipsoidC: "ellipsoid.c", "", "c", "o_1² + o_2² + o_3² − r²", "1.1.1";
    EllipsoidDiscriminant: "ellipsoid.discriminant", "", "Δ",
        "r²·a − ((o_2·d_3 − o_3·d_2)² + (o_3·d_1 − o_1·d_3)² + (o_1·d_2 − o_2·d_1)²)", "1.1.1";
    EllipsoidT1: "ellipsoid.t", "1", "t", "t_1", "1.1.1";
    EllipsoidT2: "ellipsoid.t", "2", "t", "t_2", "1.1.1";
    EllipsoidTDoubled: "ellipsoid.t", "doubled", "t", "(−b − √Δ)/a", "1.1.1";
    EllipsoidPoint: "ellipsoid.point", "", "p_e", "O − E_c + d·t", "1.1.1";
    EllipsoidPoint1: "ellipsoid.point_1", "", "p_1", "E_1 · p_e", "1.1.1";
    EllipsoidPoint2: "ellipsoid.point_2", "", "p_2", "E_2 · p_e", "1.1.1";
    EllipsoidPoint3: "ellipsoid.point_3", "", "p_3", "E_3 · p_e", "1.1.1";
    EllipsoidOffset: "ellipsoid.offset", "", "f_e", "p_1² + p_2² + p_3² − r²", "1.1.1";
    EllipsoidGradient: "ellipsoid.gradient", "", "g_e", "E_1·p_1 + E_2·p_2 + E_3·p_3", "1.1.1";

    // The roots of a·t² + 2·b·t + c, for the shapes that have two. Neither subtracts what nearly cancels.
    QuadraticQAway: "quadratic.q", "away", "q", "−b − √max(Δ, 0)", "1.1.1";
    QuadraticQToward: "quadratic.q", "toward", "q", "−b + √max(Δ, 0)", "1.1.1";
    QuadraticT1: "quadratic.t_1", "", "t_1", "q/a", "1.1.1";
    QuadraticT2: "quadratic.t_2", "", "t_2", "c/q", "1.1.1";

    // Triangle. The edge functions are named after the corner over against the edge. N_t = (B − A) × (C − A) with all its digits.
    TriangleA: "triangle.a", "", "A", "", "1.1.1";
    TriangleB: "triangle.b", "", "B", "", "1.1.1";
    TriangleC: "triangle.c", "", "C", "", "1.1.1";
    TriangleNormal: "triangle.normal", "", "N_t", "", "1.1.1";
    TriangleUnitNormal: "triangle.unit_normal", "", "ν_t", "", "1.1.1";
    TriangleEdgeA: "triangle.edge_a", "", "E_a", "d · ((C − O)×(B − O))", "1.1.1";
    TriangleEdgeB: "triangle.edge_b", "", "E_b", "d · ((A − O)×(C − O))", "1.1.1";
    TriangleEdgeC: "triangle.edge_c", "", "E_c", "d · ((B − O)×(A − O))", "1.1.1";
    TriangleEdgesExact: "triangle.edges_exact", "", "E", "", "1.1.1";
    TriangleVd: "triangle.v_d", "", "V_d", "N_t · d", "1.1.1";
    TriangleVo: "triangle.v_o", "", "V_o", "N_t · (A − O)", "1.1.1";
    TriangleT: "triangle.t", "", "t", "V_o/V_d", "1.1.1";
    TriangleTDoubled: "triangle.t", "doubled", "t", "(((B − A)×(C − A)) · (A − O))/(((B − A)×(C − A)) · d)", "1.1.1";
    TriangleTNear: "triangle.t_near", "", "t_n", "", "1.1.1";
    TriangleTFar: "triangle.t_far", "", "t_f", "", "1.1.1";
    TriangleTInBox: "triangle.t", "in_box", "t", "min(max(t, t_n), t_f)", "1.1.1";

    // The mean of the normals at a triangle's corners, by the areas over against them.
    TriangleNormalA: "triangle.normal_a", "", "N_a", "", "1.1.1";
    TriangleNormalB: "triangle.normal_b", "", "N_b", "", "1.1.1";
    TriangleNormalC: "triangle.normal_c", "", "N_c", "", "1.1.1";
    TriangleWeightA: "triangle.weight_a", "", "w_a", "(ν_t · ((B − P)×(C − P)))/(ν_t · N_t)", "1.1.1";
    TriangleWeightB: "triangle.weight_b", "", "w_b", "(ν_t · ((C − P)×(A − P)))/(ν_t · N_t)", "1.1.1";
    TriangleWeightC: "triangle.weight_c", "", "w_c", "1 − w_a − w_b", "1.1.1";
    TriangleMeanNormal: "triangle.mean_normal", "", "N_m", "w_a·N_a + w_b·N_b + w_c·N_c", "1.1.1";

    // Polygon. Q is its first corner. How many of its edges a half plane from the ray crosses has no formula.
    PolygonCorner: "polygon.corner", "", "Q", "", "1.1.1";
    PolygonNormal: "polygon.normal", "", "N_q", "", "1.1.1";
    PolygonUnitNormal: "polygon.unit_normal", "", "ν_q", "", "1.1.1";
    PolygonVd: "polygon.v_d", "", "V_d", "N_q · d", "1.1.1";
    PolygonVo: "polygon.v_o", "", "V_o", "N_q · (Q − O)", "1.1.1";
    PolygonT: "polygon.t", "", "t", "V_o/V_d", "1.1.1";
    PolygonTDoubled: "polygon.t", "doubled", "t", "(N_q · (Q − O))/(N_q · d)", "1.1.1";
    PolygonTNear: "polygon.t_near", "", "t_n", "", "1.1.1";
    PolygonTFar: "polygon.t_far", "", "t_f", "", "1.1.1";
    PolygonTInBox: "polygon.t", "in_box", "t", "min(max(t, t_n), t_f)", "1.1.1";
    PolygonCrossings: "polygon.crossings", "", "κ", "", "1.1.1";

    // Box.
    BoxMin: "box.min", "", "b_min", "", "1.1.1";
    BoxMax: "box.max", "", "b_max", "", "1.1.1";
    BoxFaceNormal: "box.face_normal", "", "ν_b", "", "1.1.1";
    BoxToMin: "box.to_min", "", "t_lo", "(b_min − O)⊘d", "1.1.1";
    BoxToMax: "box.to_max", "", "t_hi", "(b_max − O)⊘d", "1.1.1";
    BoxEntry: "box.entry", "", "t_in", "max(min(t_lo, t_hi))", "1.1.1";
    BoxExit: "box.exit", "", "t_out", "min(max(t_lo, t_hi))", "1.1.1";
    BoxTEntry: "box.t", "entry", "t", "t_in", "1.1.1";
    BoxTExit: "box.t", "exit", "t", "t_out", "1.1.1";

    // The axis of a cylinder or cone, from its base to its apex; the ray and its hit along it and across.
    AxisBase: "axis.base", "", "A_b", "", "1.1.1";
    AxisApex: "axis.apex", "", "A_a", "", "1.1.1";
    AxisDirection: "axis.direction", "", "w", "", "1.1.1";
    AxisLength: "axis.length", "", "l_w", "", "1.1.1";
    AxisOrigin: "axis.origin", "", "o_b", "O − A_b", "1.1.1";
    AxisOriginNear: "axis.origin", "near", "o_b", "O − A_b + d·t_0", "1.1.1";
    AxisOriginAlong: "axis.origin_along", "", "o_w", "o_b · w", "1.1.1";
    AxisOriginAcross: "axis.origin_across", "", "o_r", "o_b × w", "1.1.1";
    AxisRayAlong: "axis.ray_along", "", "d_w", "d · w", "1.1.1";
    AxisRayAcross: "axis.ray_across", "", "d_r", "d × w", "1.1.1";
    AxisTBase: "axis.t_base", "", "t_b", "−o_w/d_w", "1.1.1";
    AxisTApex: "axis.t_apex", "", "t_a", "(l_w − o_w)/d_w", "1.1.1";
    AxisPoint: "axis.point", "", "p_b", "O − A_b + d·t", "1.1.1";
    AxisPointAlong: "axis.point_along", "", "p_w", "p_b · w", "1.1.1";
    AxisPointAcross: "axis.point_across", "", "p_r", "p_b − w·p_w", "1.1.1";

    // Cylinder.
    CylinderRadius: "cylinder.radius", "", "r", "", "1.1.1";
    CylinderRadiusSquared: "cylinder.radius_squared", "", "r²", "", "1.1.1";
    CylinderA: "cylinder.a", "", "a", "d_r · d_r", "1.1.1";
    CylinderB: "cylinder.b", "", "b", "o_r · d_r", "1.1.1";
    CylinderC: "cylinder.c", "", "c", "o_r · o_r − r²", "1.1.1";
    CylinderDiscriminant: "cylinder.discriminant", "", "Δ", "r²·a − |o_r × d_r|²", "1.1.1";
    CylinderT1: "cylinder.t", "1", "t", "t_1", "1.1.1";
    CylinderT2: "cylinder.t", "2", "t", "t_2", "1.1.1";
    CylinderTDoubled: "cylinder.t", "doubled", "t", "(−b − √Δ)/a", "1.1.1";
    CylinderTBase: "cylinder.t", "base", "t", "t_b", "1.1.1";
    CylinderTApex: "cylinder.t", "apex", "t", "t_a", "1.1.1";

    // Cone. Its radius is r_b at the base and grows by k along the axis. A ray is reckoned from its point nearest to the
    // base, at t_0: there the radius is ρ_o, and it grows by ρ_d along the ray.
    ConeBaseRadius: "cone.base_radius", "", "r_b", "", "1.1.1";
    ConeSlope: "cone.slope", "", "k", "", "1.1.1";
    ConeTNear: "cone.t_0", "", "t_0", "−((O − A_b) · d)/(d · d)", "1.1.1";
    ConeOriginRadius: "cone.origin_radius", "", "ρ_o", "r_b + k·o_w", "1.1.1";
    ConeRayRadius: "cone.ray_radius", "", "ρ_d", "k·d_w", "1.1.1";
    ConeA: "cone.a", "", "a", "d_r · d_r − ρ_d²", "1.1.1";
    ConeB: "cone.b", "", "b", "o_r · d_r − ρ_o·ρ_d", "1.1.1";
    ConeC: "cone.c", "", "c", "o_r · o_r − ρ_o²", "1.1.1";
    ConeDiscriminant: "cone.discriminant", "", "Δ", "|o_r·ρ_d − d_r·ρ_o|² − |o_r × d_r|²", "1.1.1";
    ConeDiscriminantDoubled: "cone.discriminant", "doubled", "Δ", "|o_r·ρ_d − d_r·ρ_o|² − |o_r × d_r|²", "1.1.1";
    ConeT1: "cone.t", "1", "t", "t_0 + t_1", "1.1.1";
    ConeT2: "cone.t", "2", "t", "t_0 + t_2", "1.1.1";
    ConeTBase: "cone.t", "base", "t", "t_0 + t_b", "1.1.1";
    ConeTApex: "cone.t", "apex", "t", "t_0 + t_a", "1.1.1";
    ConeOffset: "cone.offset", "", "f_c", "|p_r| − (r_b + k·p_w)", "1.1.1";
    ConeGradient: "cone.gradient", "", "g_c", "p_r/|p_r| − w·k", "1.1.1";

    // Disk.
    DiskCenter: "disk.center", "", "C_d", "", "1.1.1";
    DiskNormal: "disk.normal", "", "N_d", "", "1.1.1";
    DiskUnitNormal: "disk.unit_normal", "", "ν_d", "", "1.1.1";
    DiskRadius: "disk.radius", "", "r_d", "", "1.1.1";
    DiskVd: "disk.v_d", "", "V_d", "N_d · d", "1.1.1";
    DiskVo: "disk.v_o", "", "V_o", "N_d · (C_d − O)", "1.1.1";
    DiskT: "disk.t", "", "t", "V_o/V_d", "1.1.1";
    DiskTDoubled: "disk.t", "doubled", "t", "(N_d · (C_d − O))/(N_d · d)", "1.1.1";
    DiskDistanceSquared: "disk.distance_squared", "", "ρ²", "|O + d·t − C_d|²", "1.1.1";

    // The nearest hit: its point, and the normal turned toward the arriving ray.
    HitPoint: "hit.point", "", "P", "O + d·t", "1.3 (3)";
    HitPointSphere: "hit.point", "on_sphere", "P", "S_c + q_s·(r/|q_s|)", "1.3 (5f)";
    HitPointEllipsoid: "hit.point", "on_ellipsoid", "P", "E_c + (p_e − g_e·(f_e/(2·(g_e · g_e))))", "1.1.1";
    HitPointCylinder: "hit.point", "on_cylinder", "P", "A_b + w·p_w + p_r·(r/|p_r|)", "1.1.1";
    HitPointCone: "hit.point", "on_cone", "P", "A_b + (p_b − g_c·(f_c/(g_c · g_c)))", "1.1.1";
    HitPointBaseCap: "hit.point", "on_base_cap", "P", "A_b + p_r", "1.1.1";
    HitPointApexCap: "hit.point", "on_apex_cap", "P", "A_a + p_r", "1.1.1";
    HitNormalPlane: "hit.normal", "plane", "N", "N_p/|N_p|", "1.3 (4)";
    HitNormalPlaneBack: "hit.normal", "plane_back", "N", "−(N_p/|N_p|)", "1.3 (4)";
    HitNormalFacing: "hit.normal", "facing", "N", "−d", "1.1.1";
    HitNormalSphere: "hit.normal", "sphere", "N", "(P − S_c)/r", "1.3 (5g)";
    HitNormalSphereBack: "hit.normal", "sphere_back", "N", "(S_c − P)/r", "1.3 (5g)";
    HitNormalOnSphere: "hit.normal", "on_sphere", "N", "q_s/|q_s|", "1.3 (5g)";
    HitNormalOnSphereBack: "hit.normal", "on_sphere_back", "N", "−q_s/|q_s|", "1.3 (5g)";
    HitNormalEllipsoid: "hit.normal", "ellipsoid", "N", "g_e/|g_e|", "1.1.1";
    HitNormalEllipsoidBack: "hit.normal", "ellipsoid_back", "N", "−g_e/|g_e|", "1.1.1";
    HitNormalCylinder: "hit.normal", "cylinder", "N", "p_r/|p_r|", "1.1.1";
    HitNormalCylinderBack: "hit.normal", "cylinder_back", "N", "−p_r/|p_r|", "1.1.1";
    HitNormalCone: "hit.normal", "cone", "N", "g_c/|g_c|", "1.1.1";
    HitNormalConeBack: "hit.normal", "cone_back", "N", "−g_c/|g_c|", "1.1.1";
    HitNormalAlongAxis: "hit.normal", "along_axis", "N", "w", "1.1.1";
    HitNormalAgainstAxis: "hit.normal", "against_axis", "N", "−w", "1.1.1";
    HitNormalTriangle: "hit.normal", "triangle", "N", "ν_t", "1.1.1";
    HitNormalTriangleBack: "hit.normal", "triangle_back", "N", "−ν_t", "1.1.1";
    HitNormalPolygon: "hit.normal", "polygon", "N", "ν_q", "1.1.1";
    HitNormalPolygonBack: "hit.normal", "polygon_back", "N", "−ν_q", "1.1.1";
    HitNormalBox: "hit.normal", "box", "N", "ν_b", "1.1.1";
    HitNormalBoxBack: "hit.normal", "box_back", "N", "−ν_b", "1.1.1";
    HitNormalDisk: "hit.normal", "disk", "N", "ν_d", "1.1.1";
    HitNormalDiskBack: "hit.normal", "disk_back", "N", "−ν_d", "1.1.1";
    // Where normals are interpolated, the surface's own one has a name of its own, and the mean lies on its side.
    HitGeometricNormalTriangle: "hit.geometric_normal", "triangle", "N_g", "ν_t", "1.1.1";
    HitGeometricNormalTriangleBack: "hit.geometric_normal", "triangle_back", "N_g", "−ν_t", "1.1.1";
    HitGeometricNormalPolygon: "hit.geometric_normal", "polygon", "N_g", "ν_q", "1.1.1";
    HitGeometricNormalPolygonBack: "hit.geometric_normal", "polygon_back", "N_g", "−ν_q", "1.1.1";
    HitNormalMean: "hit.normal", "mean", "N", "N_m/|N_m|", "1.1.1";
    HitNormalMeanTurned: "hit.normal", "mean_turned", "N", "−N_m/|N_m|", "1.1.1";
    HitNormalFlat: "hit.normal", "flat", "N", "N_g", "1.1.1";

    // The two bounces.
    ReflectDirection: "reflect.direction", "", "R", "d − 2·N·(d · N)", "1.2.2";
    // Of the notes, by which every new direction is normalised. The length has no name of its own, so that nothing rounds it.
    ReflectDirectionNormalized: "reflect.direction", "normalized", "R",
        "(d − 2·N·(d · N))/|d − 2·N·(d · N)|", "1.2.2";
    ReflectDirectionBent: "reflect.direction", "bent", "R", "(R − N_g·(R · N_g))/|R − N_g·(R · N_g)|", "1.2.2";
    RefractEta1: "refract.eta_1", "", "η_1", "", "1.2.1";
    RefractEta2: "refract.eta_2", "", "η_2", "", "1.2.1";
    RefractEta: "refract.eta", "", "η", "η_2/η_1", "1.2.1";
    RefractCos1: "refract.cos_1", "", "cosφ_1", "−(N · d)", "1.2.1";
    RefractCos2: "refract.cos_2", "", "cosφ_2", "√(η² − |d + cosφ_1·N|²)/η", "1.2.1";
    RefractCos2Printed: "refract.cos_2", "notes", "cosφ_2", "√(1 − (1 − cosφ_1²)/η²)", "1.2.1";
    RefractCos2Doubled: "refract.cos_2", "doubled", "cosφ_2", "√(1 − |d × N|²/((d · d)·(N · N)·η²))", "1.2.1";
    RefractDirection: "refract.direction", "", "T", "d/η − (cosφ_2 − cosφ_1/η)·N", "1.2.1";
    RefractDirectionNormalized: "refract.direction", "normalized", "T",
        "(d/η − (cosφ_2 − cosφ_1/η)·N)/|d/η − (cosφ_2 − cosφ_1/η)·N|", "1.2.1";
    RefractDirectionBent: "refract.direction", "bent", "T", "(T − N_g·(T · N_g))/|T − N_g·(T · N_g)|", "1.2.1";

    // A light as a surface point sees it. ℓ is not normalised, L is.
    LightPosition: "light.position", "", "F", "", "1.3 (6)";
    LightTravel: "light.travel", "", "u", "", "1.2.1";
    LightCenter: "light.center", "", "C_F", "", "1.5";
    LightEdgeU: "light.edge_u", "", "e_u", "", "1.5";
    LightEdgeV: "light.edge_v", "", "e_v", "", "1.5";
    LightRadius: "light.radius", "", "r_F", "", "1.5";
    LightColor: "light.color", "", "I_i", "", "1.2.1";
    LightConstant: "light.constant", "", "a_c", "", "1.2.1";
    LightLinear: "light.linear", "", "a_l", "", "1.2.1";
    LightQuadratic: "light.quadratic", "", "a_q", "", "1.2.1";
    LightVector: "light.vector", "", "ℓ", "F − P", "1.3 (6)";
    LightDistance: "light.distance", "", "|ℓ|", "√(ℓ · ℓ)", "1.3 (6)";
    LightDirection: "light.direction", "", "L", "ℓ/|ℓ|", "1.3 (6)";
    LightDirectionFixed: "light.direction", "directional", "L", "−u", "1.2.1";
    LightAttenuation: "light.attenuation", "", "att", "min(1, 1/(a_c + a_l·|ℓ| + a_q·|ℓ|²))", "1.2.1";
    ShadowTransmittance: "shadow.transmittance", "", "τ", "Π(W_t)", "1.2.5";

    // The local model, in H form and in R form, and its transmitted term.
    ViewDirection: "view.direction", "", "V", "−d", "1.3 (6)";
    HalfSum: "half.sum", "", "h", "L + V", "1.3 (6)";
    HalfLength: "half.length", "", "|h|", "√(h · h)", "1.3 (6)";
    HalfDirection: "half.direction", "", "H", "h/|h|", "1.3 (6)";
    MirrorDirection: "mirror.direction", "", "R_L", "2·N·N·L − L", "1.2.1";
    TransmitEta: "transmit.eta", "", "η_t", "η_2/η_1", "1.2.1";
    TransmitSum: "transmit.sum", "", "h′", "−(L + V)/(η_t − 1) − V", "1.2.1";
    // As the notes print it; their second form, with η = η_1/η_2 and L for the incident direction, is the same vector.
    TransmitSumPrinted: "transmit.sum", "notes", "h′", "(−L − η_t·V)/(η_t − 1)", "1.2.1";
    TransmitLength: "transmit.length", "", "|h′|", "√(h′ · h′)", "1.2.1";
    TransmitDirection: "transmit.direction", "", "H′", "h′/|h′|", "1.2.1";
    ShadeNDotL: "shade.n_dot_l", "", "N·L", "N · L", "1.3 (7)";
    ShadeNDotH: "shade.n_dot_h", "", "N·H", "N · H", "1.3 (7)";
    ShadeRDotV: "shade.r_dot_v", "", "R·V", "R_L · V", "1.2.1";
    ShadeNDotTransmitted: "shade.n_dot_transmitted", "", "−N·H′", "−(N · H′)", "1.2.1";
    ShadeNDotTransmittedStraight: "shade.n_dot_transmitted", "no_interface", "−N·H′", "1", "1.2.1";
    // Powers of large exponents are taken from the angle itself: near 1 its cosine has lost it.
    ShadeSpecularPower: "shade.specular_power", "", "π_e", "", "1.2.1";
    ShadeTransmittedPower: "shade.transmitted_power", "", "π_t", "", "1.2.1";
    AmbientLight: "light.ambient", "", "I_a", "", "1.2.1";
    MaterialAmbient: "material.ambient", "", "K_a", "", "1.2.1";
    MaterialAmbientPatterned: "material.ambient", "patterned", "K_a", "k_a∘c_p", "1.2.1";
    MaterialDiffuse: "material.diffuse", "", "K_d", "", "1.2.1";
    MaterialDiffusePatterned: "material.diffuse", "patterned", "K_d", "k_d∘c_p", "1.2.1";
    MaterialSpecular: "material.specular", "", "K_e", "", "1.2.1";
    MaterialShininess: "material.shininess", "", "n_e", "", "1.2.1";
    MaterialTransmission: "material.transmission", "", "K_t", "", "1.2.1";
    MaterialTransmissionExponent: "material.transmission_exponent", "", "n_t", "", "1.2.1";
    WeightLocal: "weight.local", "", "W_l", "", "1.2.3";
    ShadeLocal: "shade.local", "", "I_local",
        "I_a∘K_a + Σ(I_i·att∘τ∘(K_d·(N·L)⁺ + K_e·((N·H)⁺)^n_e))", "1.2.1";
    ShadeLocalMirror: "shade.local", "reflection_vector", "I_local",
        "I_a∘K_a + Σ(I_i·att∘τ∘(K_d·(N·L)⁺ + K_e·((R·V)⁺)^n_e))", "1.2.1";
    // The angle between N and H is half of that between R and V: with 4n the highlights are as wide.
    ShadeLocalCompensated: "shade.local", "compensated", "I_local",
        "I_a∘K_a + Σ(I_i·att∘τ∘(K_d·(N·L)⁺ + K_e·((N·H)⁺)^(4·n_e)))", "1.2.1";
    ShadeLocalCompensatedTransmitting: "shade.local", "compensated_transmitting", "I_local",
        "I_a∘K_a + Σ(I_i·att∘τ∘(K_d·(N·L)⁺ + K_e·((N·H)⁺)^(4·n_e) + K_t·((−N·H′)⁺)^n_t))", "1.2.1";
    ShadeLocalTransmitting: "shade.local", "transmitting", "I_local",
        "I_a∘K_a + Σ(I_i·att∘τ∘(K_d·(N·L)⁺ + K_e·((N·H)⁺)^n_e + K_t·((−N·H′)⁺)^n_t))", "1.2.1";
    ShadeLocalMirrorTransmitting: "shade.local", "reflection_vector_transmitting", "I_local",
        "I_a∘K_a + Σ(I_i·att∘τ∘(K_d·(N·L)⁺ + K_e·((R·V)⁺)^n_e + K_t·((−N·H′)⁺)^n_t))", "1.2.1";
    ShadeLocalSharp: "shade.local", "sharp", "I_local",
        "I_a∘K_a + Σ(I_i·att∘τ∘(K_d·(N·L)⁺ + K_e·π_e))", "1.2.1";
    ShadeLocalSharpTransmitting: "shade.local", "sharp_transmitting", "I_local",
        "I_a∘K_a + Σ(I_i·att∘τ∘(K_d·(N·L)⁺ + K_e·π_e + K_t·π_t))", "1.2.1";
    ShadeLocalAmbient: "shade.local", "ambient", "I_local", "I_a∘K_a", "1.1.2";

    // A checker pattern. m_p is 1 on the axes that count: all of them, but on a flat surface not the one nearest to its
    // normal. ξ is the cell of the point; the colour is c_a where the sum of its coordinates is even, c_b where it is odd.
    MaterialAmbientPlain: "material.ambient_plain", "", "k_a", "", "1.2.1";
    MaterialDiffusePlain: "material.diffuse_plain", "", "k_d", "", "1.2.1";
    PatternA: "pattern.a", "", "c_a", "", "1.2.1";
    PatternB: "pattern.b", "", "c_b", "", "1.2.1";
    PatternSize: "pattern.size", "", "s_p", "", "1.2.1";
    PatternAxes: "pattern.axes", "", "m_p", "", "1.2.1";
    PatternCell: "pattern.cell", "", "ξ", "⌊P/s_p⌋", "1.2.1";
    PatternSum: "pattern.sum", "", "σ", "m_p · ξ", "1.2.1";
    PatternParity: "pattern.parity", "", "π", "σ − 2·⌊σ/2⌋", "1.2.1";
    PatternColorEven: "pattern.color", "even", "c_p", "c_a", "1.2.1";
    PatternColorOdd: "pattern.color", "odd", "c_p", "c_b", "1.2.1";

    // The sum of the three contributions.
    // What the bounce at a cutoff could have added to the sample at the most: no arithmetic rounds it.
    CutoffLoss: "cutoff.loss", "", "ΔI", "", "1.1.1";
    WeightReflected: "weight.reflected", "", "W_r", "", "1.2.3";
    WeightTransmitted: "weight.transmitted", "", "W_t", "", "1.2.3";
    IncomingReflected: "incoming.reflected", "", "I_reflected", "", "1.2.3";
    IncomingTransmitted: "incoming.transmitted", "", "I_transmitted", "", "1.2.3";
    CombineLocal: "combine.local", "", "C_l", "W_l∘I_local", "1.2.3";
    CombineReflected: "combine.reflected", "", "C_r", "W_r∘I_reflected", "1.2.3";
    CombineReflectedSpecular: "combine.reflected", "specular", "C_r", "W_r∘K_e∘I_reflected", "1.1.2";
    CombineTransmitted: "combine.transmitted", "", "C_t", "W_t∘I_transmitted", "1.2.3";
    CombineColor: "combine.color", "", "I", "C_l + C_r + C_t", "1.2.3";

    // The place of a random point in the unit square, a sample's in its pixel or that of a split: in stratum i_s of the c_s of its row, a_s of all n_s lying in the rows above.
    SampleColumn: "sample.column", "", "i_s", "", "1.5";
    SampleJitterX: "sample.jitter_x", "", "ξ_x", "", "1.5";
    SampleAcross: "sample.across", "", "c_s", "", "1.5";
    SampleAbove: "sample.above", "", "a_s", "", "1.5";
    SampleJitterY: "sample.jitter_y", "", "ξ_y", "", "1.5";
    SampleCount: "sample.count", "", "n_s", "", "1.5";
    SampleX: "sample.x", "", "s_x", "(i_s + ξ_x)/c_s", "1.5";
    SampleY: "sample.y", "", "s_y", "(a_s + ξ_y·c_s)/n_s", "1.5";
    PixelLeft: "pixel.left", "", "col_0", "", "1.4.2";
    PixelTop: "pixel.top", "", "row_0", "", "1.4.2";
    PixelColumnSampled: "pixel.column", "sampled", "col", "col_0 + s_x", "1.4.2";
    PixelRowSampled: "pixel.row", "sampled", "row", "row_0 + s_y", "1.4.2";

    // Adaptive sampling: the colours at the corners of a cell, and the figures by which it is cut.
    CellColor1: "cell.color_1", "", "I_1", "", "1.4.2";
    CellColor2: "cell.color_2", "", "I_2", "", "1.4.2";
    CellColor3: "cell.color_3", "", "I_3", "", "1.4.2";
    CellColor4: "cell.color_4", "", "I_4", "", "1.4.2";
    CellThreshold: "cell.threshold", "", "θ", "", "1.4.2";
    CellLimit: "cell.limit", "", "Δ_max", "θ·w_o", "1.4.2";
    CellDifference: "cell.difference", "", "Δ_I",
        "max(max(max(I_1, I_2), max(I_3, I_4)) − min(min(I_1, I_2), min(I_3, I_4)))", "1.4.2";

    // Statistical sampling: Student's interval of the mean of the samples so far, per channel.
    StatisticalMean: "statistical.mean", "", "I_m", "Σ_s(I)/n_p", "1.4.2";
    StatisticalError: "statistical.standard_error", "", "σ_m", "", "1.4.2";
    StatisticalFreedom: "statistical.degrees_of_freedom", "", "ν_m", "", "1.4.2";
    StatisticalConfidence: "statistical.confidence", "", "γ_m", "", "1.4.2";
    StatisticalQuantile: "statistical.t_quantile", "", "t_m", "", "1.4.2";
    StatisticalHalfWidth: "statistical.half_width", "", "h_m", "t_m∘σ_m", "1.4.2";
    StatisticalWidest: "statistical.widest", "", "h_max", "max(h_m)", "1.4.2";
    StatisticalTolerance: "statistical.tolerance", "", "ε_m", "", "1.4.2";
    OutputWhite: "output.white", "", "w_o", "", "1.4.2";
    StatisticalAlike: "statistical.alike_needed", "", "n_m", "ceil(ln1p(−γ_m)/ln1p(−min(ε_m, 1)))", "1.4.2";
    StatisticalLimit: "statistical.limit", "", "h_lim", "ε_m·w_o", "1.4.2";
} }

#[cfg(test)]
mod tests;
