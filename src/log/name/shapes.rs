//! The rows of the shapes, in the order of the scene's schema: what their kernels are given and what they note.

/// Calls the macro of the table with the rows before those of this file, with them, and with the rows behind them.
macro_rules! with_shapes {
    ($table:ident! { $($before:tt)* } { $($after:tt)* }) => {
        with_effects! { $table! {
            $($before)*

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

            $($after)*
        } }
    };
}
