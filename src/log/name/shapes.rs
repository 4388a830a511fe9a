//! The rows of the shapes, in the order of the scene's schema: what their kernels are given and what they note.

/// Calls the macro of the table with the rows before those of this file, with them, and with the rows behind them.
macro_rules! with_shapes {
    ($table:ident! { $($before:tt)* } { $($after:tt)* }) => {
        with_effects! { $table! {
            $($before)*

            // Plane.
            PlaneNormal: "plane.normal", "", "N_p", "", "1.3", [One; 3];
            PlaneOffset: "plane.offset", "", "D_p", "", "1.3", Length;
            PlaneVd: "plane.v_d", "", "V_d", "N_p · d", "1.3", One;
            PlaneVo: "plane.v_o", "", "V_o", "−(N_p · O + D_p)", "1.3", Length;
            PlaneT: "plane.t", "", "t", "V_o/V_d", "1.3", Length;
            // What was computed with more digits than f64 has, as were its operands: the formula on logged values gives it within a bound.
            PlaneTDoubled: "plane.t", "doubled", "t", "V_o/V_d", "1.3", Length;

            // A ray that begins on a surface and goes through it.
            TouchT: "touch.t", "", "t", "0", "", Length;

            // Sphere: the geometric method of the source text, and the robust one (Haines et al., Ray Tracing Gems, chapter 7).
            SphereCenter: "sphere.center", "", "S_c", "", "1.3", [Length; 3];
            SphereRadius: "sphere.radius", "", "r", "", "1.3", Length;
            SphereRadiusSquared: "sphere.radius_squared", "", "r²", "", "1.3", Area;
            SphereOc: "sphere.oc", "", "OC", "S_c − O", "1.3", [Length; 3];
            SphereL2oc: "sphere.l2_oc", "", "L2oc", "OC · OC", "1.3", Area;
            SphereTa: "sphere.t_a", "", "T_A", "OC · d", "1.3", Length;
            SphereT2a: "sphere.t2_a", "", "T2_A", "r² − L2oc + T_A²", "1.3", Area;
            SphereT2aRobust: "sphere.t2_a", "robust", "T2_A", "r² − |OC − T_A·d|²", "1.3", Area;
            SphereT: "sphere.t", "", "t", "T_A − √T2_A", "1.3", Length;
            SphereTFar: "sphere.t", "far", "t", "T_A + √T2_A", "1.3", Length;
            SphereTNearRobust: "sphere.t", "near_robust", "t", "(L2oc − r²)/(T_A + √T2_A)", "1.3", Length;
            SphereTFarRobust: "sphere.t", "far_robust", "t", "(r² − L2oc)/(√T2_A − T_A)", "1.3", Length;
            SphereT2aDoubled: "sphere.t2_a", "doubled", "T2_A", "r·r − |OC − T_A·d|²", "1.3", Area;
            SphereTDoubled: "sphere.t", "doubled", "t", "T_A − √T2_A", "1.3", Length;
            SphereFromCenter: "sphere.from_center", "", "q_s", "O − S_c + d·t", "1.3", [Length; 3];
            SphereTLeaving: "sphere.t", "leaving", "t", "2·T_A", "1.3", Length;

            // Ellipsoid. E_1, E_2 and E_3 are the rows of the linear map that makes it the sphere of its largest radius.
            EllipsoidCenter: "ellipsoid.center", "", "E_c", "", "", [Length; 3];
            EllipsoidRow1: "ellipsoid.row_1", "", "E_1", "", "", [One; 3];
            EllipsoidRow2: "ellipsoid.row_2", "", "E_2", "", "", [One; 3];
            EllipsoidRow3: "ellipsoid.row_3", "", "E_3", "", "", [One; 3];
            EllipsoidRadiusSquared: "ellipsoid.radius_squared", "", "r²", "", "", Area;
            EllipsoidOrigin: "ellipsoid.origin", "", "o_e", "O − E_c", "", [Length; 3];
            EllipsoidOrigin1: "ellipsoid.origin_1", "", "o_1", "E_1 · o_e", "", Length;
            EllipsoidOrigin2: "ellipsoid.origin_2", "", "o_2", "E_2 · o_e", "", Length;
            EllipsoidOrigin3: "ellipsoid.origin_3", "", "o_3", "E_3 · o_e", "", Length;
            EllipsoidDirection1: "ellipsoid.direction_1", "", "d_1", "E_1 · d", "", One;
            EllipsoidDirection2: "ellipsoid.direction_2", "", "d_2", "E_2 · d", "", One;
            EllipsoidDirection3: "ellipsoid.direction_3", "", "d_3", "E_3 · d", "", One;
            EllipsoidA: "ellipsoid.a", "", "a", "d_1² + d_2² + d_3²", "", One;
            EllipsoidB: "ellipsoid.b", "", "b", "o_1·d_1 + o_2·d_2 + o_3·d_3", "", Length;
            EllipsoidC: "ellipsoid.c", "", "c", "o_1² + o_2² + o_3² − r²", "", Area;
            EllipsoidDiscriminant: "ellipsoid.discriminant", "", "Δ",
                "r²·a − ((o_2·d_3 − o_3·d_2)² + (o_3·d_1 − o_1·d_3)² + (o_1·d_2 − o_2·d_1)²)", "", Area;
            EllipsoidT1: "ellipsoid.t", "1", "t", "t_1", "", Length;
            EllipsoidT2: "ellipsoid.t", "2", "t", "t_2", "", Length;
            EllipsoidTDoubled: "ellipsoid.t", "doubled", "t", "(−b − √Δ)/a", "", Length;
            EllipsoidPoint: "ellipsoid.point", "", "p_e", "O − E_c + d·t", "", [Length; 3];
            EllipsoidPoint1: "ellipsoid.point_1", "", "p_1", "E_1 · p_e", "", Length;
            EllipsoidPoint2: "ellipsoid.point_2", "", "p_2", "E_2 · p_e", "", Length;
            EllipsoidPoint3: "ellipsoid.point_3", "", "p_3", "E_3 · p_e", "", Length;
            EllipsoidOffset: "ellipsoid.offset", "", "f_e", "p_1² + p_2² + p_3² − r²", "", Area;
            EllipsoidGradient: "ellipsoid.gradient", "", "g_e", "E_1·p_1 + E_2·p_2 + E_3·p_3", "", [Length; 3];

            // The roots of a·t² + 2·b·t + c, for the shapes that have two. Neither subtracts what nearly cancels.
            QuadraticQAway: "quadratic.q", "away", "q", "−b − √max(Δ, 0)", "", Length;
            QuadraticQToward: "quadratic.q", "toward", "q", "−b + √max(Δ, 0)", "", Length;
            QuadraticT1: "quadratic.t_1", "", "t_1", "q/a", "", Length;
            QuadraticT2: "quadratic.t_2", "", "t_2", "c/q", "", Length;

            // Triangle. The edge functions are named after the corner over against the edge. N_t = (B − A) × (C − A) with all its digits.
            TriangleA: "triangle.a", "", "A", "", "", [Length; 3];
            TriangleB: "triangle.b", "", "B", "", "", [Length; 3];
            TriangleC: "triangle.c", "", "C", "", "", [Length; 3];
            TriangleNormal: "triangle.normal", "", "N_t", "", "", [Area; 3];
            TriangleUnitNormal: "triangle.unit_normal", "", "ν_t", "", "", [One; 3];
            TriangleEdgeA: "triangle.edge_a", "", "E_a", "d · ((C − O)×(B − O))", "", Area;
            TriangleEdgeB: "triangle.edge_b", "", "E_b", "d · ((A − O)×(C − O))", "", Area;
            TriangleEdgeC: "triangle.edge_c", "", "E_c", "d · ((B − O)×(A − O))", "", Area;
            TriangleEdgesExact: "triangle.edges_exact", "", "E", "", "", [Area; 3];
            TriangleVd: "triangle.v_d", "", "V_d", "N_t · d", "", Area;
            TriangleVo: "triangle.v_o", "", "V_o", "N_t · (A − O)", "", Volume;
            TriangleT: "triangle.t", "", "t", "V_o/V_d", "", Length;
            TriangleTDoubled: "triangle.t", "doubled", "t", "(((B − A)×(C − A)) · (A − O))/(((B − A)×(C − A)) · d)", "", Length;
            TriangleTNear: "triangle.t_near", "", "t_n", "", "", Length;
            TriangleTFar: "triangle.t_far", "", "t_f", "", "", Length;
            TriangleTInBox: "triangle.t", "in_box", "t", "min(max(t, t_n), t_f)", "", Length;

            // The mean of the normals at a triangle's corners, by the areas over against them.
            TriangleNormalA: "triangle.normal_a", "", "N_a", "", "", [One; 3];
            TriangleNormalB: "triangle.normal_b", "", "N_b", "", "", [One; 3];
            TriangleNormalC: "triangle.normal_c", "", "N_c", "", "", [One; 3];
            TriangleWeightA: "triangle.weight_a", "", "w_a", "(ν_t · ((B − P)×(C − P)))/(ν_t · N_t)", "", One;
            TriangleWeightB: "triangle.weight_b", "", "w_b", "(ν_t · ((C − P)×(A − P)))/(ν_t · N_t)", "", One;
            TriangleWeightC: "triangle.weight_c", "", "w_c", "1 − w_a − w_b", "", One;
            TriangleMeanNormal: "triangle.mean_normal", "", "N_m", "w_a·N_a + w_b·N_b + w_c·N_c", "", [One; 3];

            // Polygon. Q is its first corner. How many of its edges a half plane from the ray crosses has no formula.
            PolygonCorner: "polygon.corner", "", "Q", "", "", [Length; 3];
            PolygonNormal: "polygon.normal", "", "N_q", "", "", [Area; 3];
            PolygonUnitNormal: "polygon.unit_normal", "", "ν_q", "", "", [One; 3];
            PolygonVd: "polygon.v_d", "", "V_d", "N_q · d", "", Area;
            PolygonVo: "polygon.v_o", "", "V_o", "N_q · (Q − O)", "", Volume;
            PolygonT: "polygon.t", "", "t", "V_o/V_d", "", Length;
            PolygonTDoubled: "polygon.t", "doubled", "t", "(N_q · (Q − O))/(N_q · d)", "", Length;
            PolygonTNear: "polygon.t_near", "", "t_n", "", "", Length;
            PolygonTFar: "polygon.t_far", "", "t_f", "", "", Length;
            PolygonTInBox: "polygon.t", "in_box", "t", "min(max(t, t_n), t_f)", "", Length;
            PolygonCrossings: "polygon.crossings", "", "κ", "", "", Count;

            // Box.
            BoxMin: "box.min", "", "b_min", "", "", [Length; 3];
            BoxMax: "box.max", "", "b_max", "", "", [Length; 3];
            BoxFaceNormal: "box.face_normal", "", "ν_b", "", "", [One; 3];
            BoxToMin: "box.to_min", "", "t_lo", "(b_min − O)⊘d", "", [Length; 3];
            BoxToMax: "box.to_max", "", "t_hi", "(b_max − O)⊘d", "", [Length; 3];
            BoxEntry: "box.entry", "", "t_in", "max(min(t_lo, t_hi))", "", Length;
            BoxExit: "box.exit", "", "t_out", "min(max(t_lo, t_hi))", "", Length;
            BoxTEntry: "box.t", "entry", "t", "t_in", "", Length;
            BoxTExit: "box.t", "exit", "t", "t_out", "", Length;

            // The axis of a cylinder or cone, from its base to its apex; the ray and its hit along it and across.
            AxisBase: "axis.base", "", "A_b", "", "", [Length; 3];
            AxisApex: "axis.apex", "", "A_a", "", "", [Length; 3];
            AxisDirection: "axis.direction", "", "w", "", "", [One; 3];
            AxisLength: "axis.length", "", "l_w", "", "", Length;
            AxisOrigin: "axis.origin", "", "o_b", "O − A_b", "", [Length; 3];
            AxisOriginNear: "axis.origin", "near", "o_b", "O − A_b + d·t_0", "", [Length; 3];
            AxisOriginAlong: "axis.origin_along", "", "o_w", "o_b · w", "", Length;
            AxisOriginAcross: "axis.origin_across", "", "o_r", "o_b × w", "", [Length; 3];
            AxisRayAlong: "axis.ray_along", "", "d_w", "d · w", "", One;
            AxisRayAcross: "axis.ray_across", "", "d_r", "d × w", "", [One; 3];
            AxisTBase: "axis.t_base", "", "t_b", "−o_w/d_w", "", Length;
            AxisTApex: "axis.t_apex", "", "t_a", "(l_w − o_w)/d_w", "", Length;
            AxisPoint: "axis.point", "", "p_b", "O − A_b + d·t", "", [Length; 3];
            AxisPointAlong: "axis.point_along", "", "p_w", "p_b · w", "", Length;
            AxisPointAcross: "axis.point_across", "", "p_r", "p_b − w·p_w", "", [Length; 3];

            // Cylinder.
            CylinderRadius: "cylinder.radius", "", "r", "", "", Length;
            CylinderRadiusSquared: "cylinder.radius_squared", "", "r²", "", "", Area;
            CylinderA: "cylinder.a", "", "a", "d_r · d_r", "", One;
            CylinderB: "cylinder.b", "", "b", "o_r · d_r", "", Length;
            CylinderC: "cylinder.c", "", "c", "o_r · o_r − r²", "", Area;
            CylinderDiscriminant: "cylinder.discriminant", "", "Δ", "r²·a − |o_r × d_r|²", "", Area;
            CylinderT1: "cylinder.t", "1", "t", "t_1", "", Length;
            CylinderT2: "cylinder.t", "2", "t", "t_2", "", Length;
            CylinderTDoubled: "cylinder.t", "doubled", "t", "(−b − √Δ)/a", "", Length;
            CylinderTBase: "cylinder.t", "base", "t", "t_b", "", Length;
            CylinderTApex: "cylinder.t", "apex", "t", "t_a", "", Length;

            // Cone. Its radius is r_b at the base and grows by k along the axis. A ray is computed from its point nearest to the
            // base, at t_0: there the radius is ρ_o, and it grows by ρ_d along the ray.
            ConeBaseRadius: "cone.base_radius", "", "r_b", "", "", Length;
            ConeSlope: "cone.slope", "", "k", "", "", One;
            ConeTNear: "cone.t_0", "", "t_0", "−((O − A_b) · d)/(d · d)", "", Length;
            ConeOriginRadius: "cone.origin_radius", "", "ρ_o", "r_b + k·o_w", "", Length;
            ConeRayRadius: "cone.ray_radius", "", "ρ_d", "k·d_w", "", One;
            ConeA: "cone.a", "", "a", "d_r · d_r − ρ_d²", "", One;
            ConeB: "cone.b", "", "b", "o_r · d_r − ρ_o·ρ_d", "", Length;
            ConeC: "cone.c", "", "c", "o_r · o_r − ρ_o²", "", Area;
            ConeDiscriminant: "cone.discriminant", "", "Δ", "|o_r·ρ_d − d_r·ρ_o|² − |o_r × d_r|²", "", Area;
            ConeDiscriminantDoubled: "cone.discriminant", "doubled", "Δ", "|o_r·ρ_d − d_r·ρ_o|² − |o_r × d_r|²", "", Area;
            ConeT1: "cone.t", "1", "t", "t_0 + t_1", "", Length;
            ConeT2: "cone.t", "2", "t", "t_0 + t_2", "", Length;
            ConeTBase: "cone.t", "base", "t", "t_0 + t_b", "", Length;
            ConeTApex: "cone.t", "apex", "t", "t_0 + t_a", "", Length;
            ConeOffset: "cone.offset", "", "f_c", "|p_r| − (r_b + k·p_w)", "", Length;
            ConeGradient: "cone.gradient", "", "g_c", "p_r/|p_r| − w·k", "", [One; 3];

            // Disk.
            DiskCenter: "disk.center", "", "C_d", "", "", [Length; 3];
            DiskNormal: "disk.normal", "", "N_d", "", "", [One; 3];
            DiskUnitNormal: "disk.unit_normal", "", "ν_d", "", "", [One; 3];
            DiskRadius: "disk.radius", "", "r_d", "", "", Length;
            DiskVd: "disk.v_d", "", "V_d", "N_d · d", "", One;
            DiskVo: "disk.v_o", "", "V_o", "N_d · (C_d − O)", "", Length;
            DiskT: "disk.t", "", "t", "V_o/V_d", "", Length;
            DiskTDoubled: "disk.t", "doubled", "t", "(N_d · (C_d − O))/(N_d · d)", "", Length;
            DiskDistanceSquared: "disk.distance_squared", "", "ρ²", "|O + d·t − C_d|²", "", Area;

            $($after)*
        } }
    };
}
