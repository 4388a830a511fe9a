//! The named quantities: their keys in a log, their symbols and formulas on paper, and where the source text has them.
//!
//! One row a quantity. Adding a logged quantity is one row here and one `note` in the kernel that computes it. A formula
//! is written with the symbols of this same table (see [`super::formula`] for its grammar), and a test evaluates every
//! formula on the logged operands and must get the logged value. An event has its inputs in the order of this table, so that
//! their order in a file doesn't matter: a row is behind those of the inputs that are given before it.

#[macro_use]
mod row;
#[macro_use]
mod effects;
mod unit;

use row::Row;
pub use unit::Unit;

with_effects! { names! {
    // The camera and its ray. G is the direction of view, e_x and e_y point right and up in the picture.
    RayOrigin: "ray.origin", "", "O", "", "";
    CameraDirection: "camera.direction", "", "G", "", "";
    CameraUpAsGiven: "camera.up_as_given", "", "G_u", "", "";
    CameraLength: "camera.length", "", "|G|", "√(G · G)", "";
    CameraRight: "camera.right", "", "e_x", "(G×G_u)/|G×G_u|", "";
    CameraUp: "camera.up", "", "e_y", "((G×G_u)×G)/|(G×G_u)×G|", "";
    PixelColumn: "pixel.column", "", "col", "", "";
    PixelMiddleColumn: "pixel.middle_column", "", "col_m", "", "";
    PixelRow: "pixel.row", "", "row", "", "";
    PixelMiddleRow: "pixel.middle_row", "", "row_m", "", "";
    PixelSide: "pixel.side", "", "px", "2·tan(θ_v°/2)/n_v", "";
    PixelX: "pixel.x", "", "x", "(col − col_m)·px", "";
    PixelY: "pixel.y", "", "y", "(row_m − row)·px", "";
    RayVector: "ray.vector", "", "D", "G + |G|·(x·e_x + y·e_y)", "";
    RayLength: "ray.length", "", "|D|", "√(D · D)", "1.3";
    RayDirection: "ray.direction", "", "d", "D/|D|", "1.3";

    // Plane.
    PlaneNormal: "plane.normal", "", "N_p", "", "1.3";
    PlaneOffset: "plane.offset", "", "D_p", "", "1.3";
    PlaneVd: "plane.v_d", "", "V_d", "N_p · d", "1.3";
    PlaneVo: "plane.v_o", "", "V_o", "−(N_p · O + D_p)", "1.3";
    PlaneT: "plane.t", "", "t", "V_o/V_d", "1.3";
    // What was computed with more digits than f64 has, as were its operands: the formula on logged values gives it within a bound.
    PlaneTDoubled: "plane.t", "doubled", "t", "V_o/V_d", "1.3";

    // A ray that begins on a surface and goes through it.
    TouchT: "touch.t", "", "t", "0", "";

    // Sphere: the geometric method of the source text, and the robust one (Haines et al., Ray Tracing Gems, chapter 7).
    SphereCenter: "sphere.center", "", "S_c", "", "1.3";
    SphereRadius: "sphere.radius", "", "r", "", "1.3";
    SphereRadiusSquared: "sphere.radius_squared", "", "r²", "", "1.3";
    SphereOc: "sphere.oc", "", "OC", "S_c − O", "1.3";
    SphereL2oc: "sphere.l2_oc", "", "L2oc", "OC · OC", "1.3";
    SphereTa: "sphere.t_a", "", "T_A", "OC · d", "1.3";
    SphereT2a: "sphere.t2_a", "", "T2_A", "r² − L2oc + T_A²", "1.3";
    SphereT2aRobust: "sphere.t2_a", "robust", "T2_A", "r² − |OC − T_A·d|²", "1.3";
    SphereT: "sphere.t", "", "t", "T_A − √T2_A", "1.3";
    SphereTFar: "sphere.t", "far", "t", "T_A + √T2_A", "1.3";
    SphereTNearRobust: "sphere.t", "near_robust", "t", "(L2oc − r²)/(T_A + √T2_A)", "1.3";
    SphereTFarRobust: "sphere.t", "far_robust", "t", "(r² − L2oc)/(√T2_A − T_A)", "1.3";
    SphereT2aDoubled: "sphere.t2_a", "doubled", "T2_A", "r·r − |OC − T_A·d|²", "1.3";
    SphereTDoubled: "sphere.t", "doubled", "t", "T_A − √T2_A", "1.3";
    SphereFromCenter: "sphere.from_center", "", "q_s", "O − S_c + d·t", "1.3";
    SphereTLeaving: "sphere.t", "leaving", "t", "2·T_A", "1.3";

    // Ellipsoid. E_1, E_2 and E_3 are the rows of the linear map that makes it the sphere of its largest radius.
    EllipsoidCenter: "ellipsoid.center", "", "E_c", "", "";
    EllipsoidRow1: "ellipsoid.row_1", "", "E_1", "", "";
    EllipsoidRow2: "ellipsoid.row_2", "", "E_2", "", "";
    EllipsoidRow3: "ellipsoid.row_3", "", "E_3", "", "";
    EllipsoidRadiusSquared: "ellipsoid.radius_squared", "", "r²", "", "";
    EllipsoidOrigin: "ellipsoid.origin", "", "o_e", "O − E_c", "";
    EllipsoidOrigin1: "ellipsoid.origin_1", "", "o_1", "E_1 · o_e", "";
    EllipsoidOrigin2: "ellipsoid.origin_2", "", "o_2", "E_2 · o_e", "";
    EllipsoidOrigin3: "ellipsoid.origin_3", "", "o_3", "E_3 · o_e", "";
    EllipsoidDirection1: "ellipsoid.direction_1", "", "d_1", "E_1 · d", "";
    EllipsoidDirection2: "ellipsoid.direction_2", "", "d_2", "E_2 · d", "";
    EllipsoidDirection3: "ellipsoid.direction_3", "", "d_3", "E_3 · d", "";
    EllipsoidA: "ellipsoid.a", "", "a", "d_1² + d_2² + d_3²", "";
    EllipsoidB: "ellipsoid.b", "", "b", "o_1·d_1 + o_2·d_2 + o_3·d_3", "";
    EllipsoidC: "ellipsoid.c", "", "c", "o_1² + o_2² + o_3² − r²", "";
    EllipsoidDiscriminant: "ellipsoid.discriminant", "", "Δ",
        "r²·a − ((o_2·d_3 − o_3·d_2)² + (o_3·d_1 − o_1·d_3)² + (o_1·d_2 − o_2·d_1)²)", "";
    EllipsoidT1: "ellipsoid.t", "1", "t", "t_1", "";
    EllipsoidT2: "ellipsoid.t", "2", "t", "t_2", "";
    EllipsoidTDoubled: "ellipsoid.t", "doubled", "t", "(−b − √Δ)/a", "";
    EllipsoidPoint: "ellipsoid.point", "", "p_e", "O − E_c + d·t", "";
    EllipsoidPoint1: "ellipsoid.point_1", "", "p_1", "E_1 · p_e", "";
    EllipsoidPoint2: "ellipsoid.point_2", "", "p_2", "E_2 · p_e", "";
    EllipsoidPoint3: "ellipsoid.point_3", "", "p_3", "E_3 · p_e", "";
    EllipsoidOffset: "ellipsoid.offset", "", "f_e", "p_1² + p_2² + p_3² − r²", "";
    EllipsoidGradient: "ellipsoid.gradient", "", "g_e", "E_1·p_1 + E_2·p_2 + E_3·p_3", "";

    // The roots of a·t² + 2·b·t + c, for the shapes that have two. Neither subtracts what nearly cancels.
    QuadraticQAway: "quadratic.q", "away", "q", "−b − √max(Δ, 0)", "";
    QuadraticQToward: "quadratic.q", "toward", "q", "−b + √max(Δ, 0)", "";
    QuadraticT1: "quadratic.t_1", "", "t_1", "q/a", "";
    QuadraticT2: "quadratic.t_2", "", "t_2", "c/q", "";

    // Triangle. The edge functions are named after the corner over against the edge. N_t = (B − A) × (C − A) with all its digits.
    TriangleA: "triangle.a", "", "A", "", "";
    TriangleB: "triangle.b", "", "B", "", "";
    TriangleC: "triangle.c", "", "C", "", "";
    TriangleNormal: "triangle.normal", "", "N_t", "", "";
    TriangleUnitNormal: "triangle.unit_normal", "", "ν_t", "", "";
    TriangleEdgeA: "triangle.edge_a", "", "E_a", "d · ((C − O)×(B − O))", "";
    TriangleEdgeB: "triangle.edge_b", "", "E_b", "d · ((A − O)×(C − O))", "";
    TriangleEdgeC: "triangle.edge_c", "", "E_c", "d · ((B − O)×(A − O))", "";
    TriangleEdgesExact: "triangle.edges_exact", "", "E", "", "";
    TriangleVd: "triangle.v_d", "", "V_d", "N_t · d", "";
    TriangleVo: "triangle.v_o", "", "V_o", "N_t · (A − O)", "";
    TriangleT: "triangle.t", "", "t", "V_o/V_d", "";
    TriangleTDoubled: "triangle.t", "doubled", "t", "(((B − A)×(C − A)) · (A − O))/(((B − A)×(C − A)) · d)", "";
    TriangleTNear: "triangle.t_near", "", "t_n", "", "";
    TriangleTFar: "triangle.t_far", "", "t_f", "", "";
    TriangleTInBox: "triangle.t", "in_box", "t", "min(max(t, t_n), t_f)", "";

    // The mean of the normals at a triangle's corners, by the areas over against them.
    TriangleNormalA: "triangle.normal_a", "", "N_a", "", "";
    TriangleNormalB: "triangle.normal_b", "", "N_b", "", "";
    TriangleNormalC: "triangle.normal_c", "", "N_c", "", "";
    TriangleWeightA: "triangle.weight_a", "", "w_a", "(ν_t · ((B − P)×(C − P)))/(ν_t · N_t)", "";
    TriangleWeightB: "triangle.weight_b", "", "w_b", "(ν_t · ((C − P)×(A − P)))/(ν_t · N_t)", "";
    TriangleWeightC: "triangle.weight_c", "", "w_c", "1 − w_a − w_b", "";
    TriangleMeanNormal: "triangle.mean_normal", "", "N_m", "w_a·N_a + w_b·N_b + w_c·N_c", "";

    // Polygon. Q is its first corner. How many of its edges a half plane from the ray crosses has no formula.
    PolygonCorner: "polygon.corner", "", "Q", "", "";
    PolygonNormal: "polygon.normal", "", "N_q", "", "";
    PolygonUnitNormal: "polygon.unit_normal", "", "ν_q", "", "";
    PolygonVd: "polygon.v_d", "", "V_d", "N_q · d", "";
    PolygonVo: "polygon.v_o", "", "V_o", "N_q · (Q − O)", "";
    PolygonT: "polygon.t", "", "t", "V_o/V_d", "";
    PolygonTDoubled: "polygon.t", "doubled", "t", "(N_q · (Q − O))/(N_q · d)", "";
    PolygonTNear: "polygon.t_near", "", "t_n", "", "";
    PolygonTFar: "polygon.t_far", "", "t_f", "", "";
    PolygonTInBox: "polygon.t", "in_box", "t", "min(max(t, t_n), t_f)", "";
    PolygonCrossings: "polygon.crossings", "", "κ", "", "";

    // Box.
    BoxMin: "box.min", "", "b_min", "", "";
    BoxMax: "box.max", "", "b_max", "", "";
    BoxFaceNormal: "box.face_normal", "", "ν_b", "", "";
    BoxToMin: "box.to_min", "", "t_lo", "(b_min − O)⊘d", "";
    BoxToMax: "box.to_max", "", "t_hi", "(b_max − O)⊘d", "";
    BoxEntry: "box.entry", "", "t_in", "max(min(t_lo, t_hi))", "";
    BoxExit: "box.exit", "", "t_out", "min(max(t_lo, t_hi))", "";
    BoxTEntry: "box.t", "entry", "t", "t_in", "";
    BoxTExit: "box.t", "exit", "t", "t_out", "";

    // The axis of a cylinder or cone, from its base to its apex; the ray and its hit along it and across.
    AxisBase: "axis.base", "", "A_b", "", "";
    AxisApex: "axis.apex", "", "A_a", "", "";
    AxisDirection: "axis.direction", "", "w", "", "";
    AxisLength: "axis.length", "", "l_w", "", "";
    AxisOrigin: "axis.origin", "", "o_b", "O − A_b", "";
    AxisOriginNear: "axis.origin", "near", "o_b", "O − A_b + d·t_0", "";
    AxisOriginAlong: "axis.origin_along", "", "o_w", "o_b · w", "";
    AxisOriginAcross: "axis.origin_across", "", "o_r", "o_b × w", "";
    AxisRayAlong: "axis.ray_along", "", "d_w", "d · w", "";
    AxisRayAcross: "axis.ray_across", "", "d_r", "d × w", "";
    AxisTBase: "axis.t_base", "", "t_b", "−o_w/d_w", "";
    AxisTApex: "axis.t_apex", "", "t_a", "(l_w − o_w)/d_w", "";
    AxisPoint: "axis.point", "", "p_b", "O − A_b + d·t", "";
    AxisPointAlong: "axis.point_along", "", "p_w", "p_b · w", "";
    AxisPointAcross: "axis.point_across", "", "p_r", "p_b − w·p_w", "";

    // Cylinder.
    CylinderRadius: "cylinder.radius", "", "r", "", "";
    CylinderRadiusSquared: "cylinder.radius_squared", "", "r²", "", "";
    CylinderA: "cylinder.a", "", "a", "d_r · d_r", "";
    CylinderB: "cylinder.b", "", "b", "o_r · d_r", "";
    CylinderC: "cylinder.c", "", "c", "o_r · o_r − r²", "";
    CylinderDiscriminant: "cylinder.discriminant", "", "Δ", "r²·a − |o_r × d_r|²", "";
    CylinderT1: "cylinder.t", "1", "t", "t_1", "";
    CylinderT2: "cylinder.t", "2", "t", "t_2", "";
    CylinderTDoubled: "cylinder.t", "doubled", "t", "(−b − √Δ)/a", "";
    CylinderTBase: "cylinder.t", "base", "t", "t_b", "";
    CylinderTApex: "cylinder.t", "apex", "t", "t_a", "";

    // Cone. Its radius is r_b at the base and grows by k along the axis. A ray is computed from its point nearest to the
    // base, at t_0: there the radius is ρ_o, and it grows by ρ_d along the ray.
    ConeBaseRadius: "cone.base_radius", "", "r_b", "", "";
    ConeSlope: "cone.slope", "", "k", "", "";
    ConeTNear: "cone.t_0", "", "t_0", "−((O − A_b) · d)/(d · d)", "";
    ConeOriginRadius: "cone.origin_radius", "", "ρ_o", "r_b + k·o_w", "";
    ConeRayRadius: "cone.ray_radius", "", "ρ_d", "k·d_w", "";
    ConeA: "cone.a", "", "a", "d_r · d_r − ρ_d²", "";
    ConeB: "cone.b", "", "b", "o_r · d_r − ρ_o·ρ_d", "";
    ConeC: "cone.c", "", "c", "o_r · o_r − ρ_o²", "";
    ConeDiscriminant: "cone.discriminant", "", "Δ", "|o_r·ρ_d − d_r·ρ_o|² − |o_r × d_r|²", "";
    ConeDiscriminantDoubled: "cone.discriminant", "doubled", "Δ", "|o_r·ρ_d − d_r·ρ_o|² − |o_r × d_r|²", "";
    ConeT1: "cone.t", "1", "t", "t_0 + t_1", "";
    ConeT2: "cone.t", "2", "t", "t_0 + t_2", "";
    ConeTBase: "cone.t", "base", "t", "t_0 + t_b", "";
    ConeTApex: "cone.t", "apex", "t", "t_0 + t_a", "";
    ConeOffset: "cone.offset", "", "f_c", "|p_r| − (r_b + k·p_w)", "";
    ConeGradient: "cone.gradient", "", "g_c", "p_r/|p_r| − w·k", "";

    // Disk.
    DiskCenter: "disk.center", "", "C_d", "", "";
    DiskNormal: "disk.normal", "", "N_d", "", "";
    DiskUnitNormal: "disk.unit_normal", "", "ν_d", "", "";
    DiskRadius: "disk.radius", "", "r_d", "", "";
    DiskVd: "disk.v_d", "", "V_d", "N_d · d", "";
    DiskVo: "disk.v_o", "", "V_o", "N_d · (C_d − O)", "";
    DiskT: "disk.t", "", "t", "V_o/V_d", "";
    DiskTDoubled: "disk.t", "doubled", "t", "(N_d · (C_d − O))/(N_d · d)", "";
    DiskDistanceSquared: "disk.distance_squared", "", "ρ²", "|O + d·t − C_d|²", "";

    // The nearest hit: its point, and the normal turned toward the arriving ray.
    HitPoint: "hit.point", "", "P", "O + d·t", "1.3";
    HitPointSphere: "hit.point", "on_sphere", "P", "S_c + q_s·(r/|q_s|)", "1.3";
    HitPointEllipsoid: "hit.point", "on_ellipsoid", "P", "E_c + (p_e − g_e·(f_e/(2·(g_e · g_e))))", "";
    HitPointCylinder: "hit.point", "on_cylinder", "P", "A_b + w·p_w + p_r·(r/|p_r|)", "";
    HitPointCone: "hit.point", "on_cone", "P", "A_b + (p_b − g_c·(f_c/(g_c · g_c)))", "";
    HitPointBaseCap: "hit.point", "on_base_cap", "P", "A_b + p_r", "";
    HitPointApexCap: "hit.point", "on_apex_cap", "P", "A_a + p_r", "";
    HitNormalPlane: "hit.normal", "plane", "N", "N_p/|N_p|", "1.3";
    HitNormalPlaneBack: "hit.normal", "plane_back", "N", "−(N_p/|N_p|)", "1.3";
    HitNormalFacing: "hit.normal", "facing", "N", "−d", "";
    HitNormalSphere: "hit.normal", "sphere", "N", "(P − S_c)/r", "1.3";
    HitNormalSphereBack: "hit.normal", "sphere_back", "N", "(S_c − P)/r", "1.3";
    HitNormalOnSphere: "hit.normal", "on_sphere", "N", "q_s/|q_s|", "1.3";
    HitNormalOnSphereBack: "hit.normal", "on_sphere_back", "N", "−q_s/|q_s|", "1.3";
    HitNormalEllipsoid: "hit.normal", "ellipsoid", "N", "g_e/|g_e|", "";
    HitNormalEllipsoidBack: "hit.normal", "ellipsoid_back", "N", "−g_e/|g_e|", "";
    HitNormalCylinder: "hit.normal", "cylinder", "N", "p_r/|p_r|", "";
    HitNormalCylinderBack: "hit.normal", "cylinder_back", "N", "−p_r/|p_r|", "";
    HitNormalCone: "hit.normal", "cone", "N", "g_c/|g_c|", "";
    HitNormalConeBack: "hit.normal", "cone_back", "N", "−g_c/|g_c|", "";
    HitNormalAlongAxis: "hit.normal", "along_axis", "N", "w", "";
    HitNormalAgainstAxis: "hit.normal", "against_axis", "N", "−w", "";
    HitNormalTriangle: "hit.normal", "triangle", "N", "ν_t", "";
    HitNormalTriangleBack: "hit.normal", "triangle_back", "N", "−ν_t", "";
    HitNormalPolygon: "hit.normal", "polygon", "N", "ν_q", "";
    HitNormalPolygonBack: "hit.normal", "polygon_back", "N", "−ν_q", "";
    HitNormalBox: "hit.normal", "box", "N", "ν_b", "";
    HitNormalBoxBack: "hit.normal", "box_back", "N", "−ν_b", "";
    HitNormalDisk: "hit.normal", "disk", "N", "ν_d", "";
    HitNormalDiskBack: "hit.normal", "disk_back", "N", "−ν_d", "";
    // Where normals are interpolated, the surface's own one has a name of its own, and the mean lies on its side.
    HitGeometricNormalTriangle: "hit.geometric_normal", "triangle", "N_g", "ν_t", "";
    HitGeometricNormalTriangleBack: "hit.geometric_normal", "triangle_back", "N_g", "−ν_t", "";
    HitGeometricNormalPolygon: "hit.geometric_normal", "polygon", "N_g", "ν_q", "";
    HitGeometricNormalPolygonBack: "hit.geometric_normal", "polygon_back", "N_g", "−ν_q", "";
    HitNormalMean: "hit.normal", "mean", "N", "N_m/|N_m|", "";
    HitNormalMeanTurned: "hit.normal", "mean_turned", "N", "−N_m/|N_m|", "";
    HitNormalFlat: "hit.normal", "flat", "N", "N_g", "";

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
    LightPosition: "light.position", "", "F", "", "1.3";
    LightTravel: "light.travel", "", "u", "", "1.2.1";
    LightCenter: "light.center", "", "C_F", "", "1.5";
    LightEdgeU: "light.edge_u", "", "e_u", "", "1.5";
    LightEdgeV: "light.edge_v", "", "e_v", "", "1.5";
    LightRadius: "light.radius", "", "r_F", "", "1.5";
    LightColor: "light.color", "", "I_i", "", "1.2.1";
    LightConstant: "light.constant", "", "a_c", "", "1.2.1";
    LightLinear: "light.linear", "", "a_l", "", "1.2.1";
    LightQuadratic: "light.quadratic", "", "a_q", "", "1.2.1";
    LightVector: "light.vector", "", "ℓ", "F − P", "1.3";
    LightDistance: "light.distance", "", "|ℓ|", "√(ℓ · ℓ)", "1.3";
    LightDirection: "light.direction", "", "L", "ℓ/|ℓ|", "1.3";
    LightDirectionFixed: "light.direction", "directional", "L", "−u", "1.2.1";
    LightAttenuation: "light.attenuation", "", "att", "min(1, 1/(a_c + a_l·|ℓ| + a_q·|ℓ|²))", "1.2.1";
    ShadowTransmittance: "shadow.transmittance", "", "τ", "Π(W_t)", "1.2.5";

    // The local model, in H form and in R form, and its transmitted term.
    ViewDirection: "view.direction", "", "V", "−d", "1.3";
    HalfSum: "half.sum", "", "h", "L + V", "1.3";
    HalfLength: "half.length", "", "|h|", "√(h · h)", "1.3";
    HalfDirection: "half.direction", "", "H", "h/|h|", "1.3";
    MirrorDirection: "mirror.direction", "", "R_L", "2·N·N·L − L", "1.2.1";
    TransmitEta: "transmit.eta", "", "η_t", "η_2/η_1", "1.2.1";
    TransmitSum: "transmit.sum", "", "h′", "−(L + V)/(η_t − 1) − V", "1.2.1";
    // As the notes print it; their second form, with η = η_1/η_2 and L for the incident direction, is the same vector.
    TransmitSumPrinted: "transmit.sum", "notes", "h′", "(−L − η_t·V)/(η_t − 1)", "1.2.1";
    TransmitLength: "transmit.length", "", "|h′|", "√(h′ · h′)", "1.2.1";
    TransmitDirection: "transmit.direction", "", "H′", "h′/|h′|", "1.2.1";
    ShadeNDotL: "shade.n_dot_l", "", "N·L", "N · L", "1.3";
    ShadeNDotH: "shade.n_dot_h", "", "N·H", "N · H", "1.3";
    ShadeRDotV: "shade.r_dot_v", "", "R·V", "R_L · V", "1.2.1";
    ShadeNDotTransmitted: "shade.n_dot_transmitted", "", "−N·H′", "−(N · H′)", "1.2.1";
    ShadeNDotTransmittedStraight: "shade.n_dot_transmitted", "no_interface", "−N·H′", "1", "1.2.1";
    // Powers of large exponents are taken from the angle itself: near 1 its cosine has lost it.
    ShadeSpecularPower: "shade.specular_power", "", "π_e", "((N·H)⁺)^n_e", "1.2.1";
    ShadeSpecularPowerCompensated: "shade.specular_power", "compensated", "π_e", "((N·H)⁺)^(4·n_e)", "1.2.1";
    ShadeSpecularPowerMirror: "shade.specular_power", "reflection_vector", "π_e", "((R·V)⁺)^n_e", "1.2.1";
    ShadeSpecularPowerSine: "shade.specular_power", "sine", "π_e",
        "exp(n_e/2·ln1p(−min(|H × (N − H)|²/((H · H)·(N · N)), 1)))", "1.2.1";
    ShadeSpecularPowerCompensatedSine: "shade.specular_power", "compensated_sine", "π_e",
        "exp(4·n_e/2·ln1p(−min(|H × (N − H)|²/((H · H)·(N · N)), 1)))", "1.2.1";
    ShadeSpecularPowerMirrorSine: "shade.specular_power", "reflection_vector_sine", "π_e",
        "exp(n_e/2·ln1p(−min(|R_L × (V − R_L)|²/((R_L · R_L)·(V · V)), 1)))", "1.2.1";
    ShadeTransmittedPower: "shade.transmitted_power", "", "π_t", "((−N·H′)⁺)^n_t", "1.2.1";
    ShadeTransmittedPowerSine: "shade.transmitted_power", "sine", "π_t",
        "exp(n_t/2·ln1p(−min(|N × (H′ + N)|²/((N · N)·(H′ · H′)), 1)))", "1.2.1";
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
    // What the bounce at a cutoff could have added to the sample at most: no arithmetic rounds it.
    CutoffLoss: "cutoff.loss", "", "ΔI", "", "";
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
} }

#[cfg(test)]
mod tests;
