//! The rows of distributed effects (Ramos, section 1.5): lens, shutter, motion, area lights, blurred bounces.

/// Calls the macro of the table with the rows that it is given and those of this file.
macro_rules! with_effects {
    ($table:ident! { $($rows:tt)* }) => {
        $table! {
            $($rows)*

            // Statistical sampling: Student's interval of the mean of the samples so far, per channel.
            StatisticalMean: "statistical.mean", "", "I_m", "Σ_s(I)/n_p", "1.4.2", [Intensity; 3];
            StatisticalError: "statistical.standard_error", "", "σ_m", "se_s(I)", "1.4.2", [Intensity; 3];
            StatisticalFreedom: "statistical.degrees_of_freedom", "", "ν_m", "df_s(I)", "1.4.2", [Count; 3];
            StatisticalConfidence: "statistical.confidence", "", "γ_m", "", "1.4.2", One;
            StatisticalQuantile: "statistical.t_quantile", "", "t_m", "student(γ_m, ν_m)", "1.4.2", [One; 3];
            StatisticalHalfWidth: "statistical.half_width", "", "h_m", "t_m∘σ_m", "1.4.2", [Intensity; 3];
            StatisticalWidest: "statistical.widest", "", "h_max", "max(h_m)", "1.4.2", Intensity;
            StatisticalTolerance: "statistical.tolerance", "", "ε_m", "", "1.4.2", One;
            OutputWhite: "output.white", "", "w_o", "", "1.4.2", Intensity;
            StatisticalAlike: "statistical.alike_needed", "", "n_m", "ceil(ln1p(−γ_m)/ln1p(−min(ε_m, 1)))", "1.4.2", Count;
            StatisticalLimit: "statistical.limit", "", "h_lim", "ε_m·w_o", "1.4.2", Intensity;

            // Guided sampling: the pilots of the pixels around, in parts of white, and how many samples they ask for.
            GuidedVariance: "guided.variance", "", "V_g", "", "1.4.2", One;
            GuidedContrast: "guided.contrast", "", "K_g", "", "1.4.2", One;
            GuidedError: "guided.error", "", "σ_g", "√(V_g + (0.25·K_g)²)", "1.4.2", One;
            GuidedTolerance: "guided.tolerance", "", "ε_g", "", "1.4.2", One;
            GuidedAsked: "guided.asked", "", "n_g", "(σ_g/ε_g)^0.75", "1.4.2", Count;

            // Quantities that raywalk notes with the form of their formula only, as another program may log them: without one.
            EllipsoidTFormless: "ellipsoid.t", "", "t", "", "", Length;
            QuadraticQFormless: "quadratic.q", "", "q", "", "", Length;
            BoxTFormless: "box.t", "", "t", "", "", Length;
            CylinderTFormless: "cylinder.t", "", "t", "", "", Length;
            ConeTFormless: "cone.t", "", "t", "", "", Length;
            HitNormalFormless: "hit.normal", "", "N", "", "1.3", [One; 3];
            HitGeometricNormalFormless: "hit.geometric_normal", "", "N_g", "", "", [One; 3];
            PatternColorFormless: "pattern.color", "", "c_p", "", "1.2.1", [One; 3];

            // The lens. The eye is its centre; (x_D, y_D) is a point of the unit disc, to which the unit square is bent.
            CameraPosition: "camera.position", "", "O_e", "", "1.5", [Length; 3];
            LensFocusDistance: "lens.focus_distance", "", "f_l", "", "1.5", Length;
            LensFocus: "lens.focus", "", "Q_l", "O_e + D·(f_l/|G|)", "1.5", [Length; 3];
            DiscX: "disc.x", "", "x_D", "", "1.5", One;
            DiscY: "disc.y", "", "y_D", "", "1.5", One;
            LensRadius: "lens.radius", "", "r_l", "", "1.5", Length;
            RayOriginLens: "ray.origin", "lens", "O", "O_e + (e_x·x_D + e_y·y_D)·r_l", "1.5", [Length; 3];
            RayVectorLens: "ray.vector", "lens", "D", "Q_l − O", "1.5", [Length; 3];

            // The time of a ray.
            ShutterOpen: "shutter.open", "", "t_open", "", "1.5", Time;
            SampleTime: "sample.time", "", "ξ_t", "", "1.5", One;
            ShutterClose: "shutter.close", "", "t_close", "", "1.5", Time;
            RayTime: "ray.time", "", "t_now", "", "1.5", Time;
            RayTimeSampled: "ray.time", "sampled", "t_now", "t_open + ξ_t·(t_close − t_open)", "1.5", Time;

            // A moving object. The ray is carried into the object's own frame, where it is at time 0, and the hit back: by the
            // shift s_M, and by the turn φ_M (degrees) about the unit axis a_M through p_M (Rodrigues' formula).
            MotionTranslation: "motion.translation", "", "v_M", "", "1.5", [LengthPerTime; 3];
            MotionShift: "motion.shift", "", "s_M", "v_M·t_now", "1.5", [Length; 3];
            MotionAxis: "motion.axis", "", "a_M", "", "1.5", [One; 3];
            MotionPoint: "motion.point", "", "p_M", "", "1.5", [Length; 3];
            MotionDegrees: "motion.degrees", "", "ω_M", "", "1.5", DegreesPerTime;
            MotionAngle: "motion.angle", "", "φ_M", "ω_M·t_now", "1.5", Degrees;
            MotionCos: "motion.cos", "", "cosφ_M", "cos(φ_M°)", "1.5", One;
            MotionSin: "motion.sin", "", "sinφ_M", "sin(φ_M°)", "1.5", One;
            MotionArm: "motion.arm", "", "b_M", "O − s_M − p_M", "1.5", [Length; 3];
            MotionArmHit: "motion.arm", "hit", "b_M", "P_M − p_M", "1.5", [Length; 3];
            MotionArmPattern: "motion.arm", "pattern", "b_M", "P − s_M − p_M", "1.5", [Length; 3];
            MotionHitPoint: "motion.hit_point", "", "P_M", "", "1.5", [Length; 3];
            MotionHitNormal: "motion.hit_normal", "", "N_M", "", "1.5", [One; 3];
            MotionGeometricNormal: "motion.geometric_normal", "", "G_M", "", "1.5", [One; 3];
            RayOriginShifted: "ray.origin", "shifted_back", "O", "O − s_M", "1.5", [Length; 3];
            RayOriginTurned: "ray.origin", "turned_back", "O",
                "b_M·cosφ_M − (a_M × b_M)·sinφ_M + a_M·((a_M · b_M)·(1 − cosφ_M)) + p_M", "1.5", [Length; 3];
            RayDirectionTurned: "ray.direction", "turned_back", "d",
                "d·cosφ_M − (a_M × d)·sinφ_M + a_M·((a_M · d)·(1 − cosφ_M))", "1.5", [One; 3];
            HitPointShifted: "hit.point", "shifted", "P", "P_M + s_M", "1.5", [Length; 3];
            HitPointTurned: "hit.point", "turned", "P",
                "b_M·cosφ_M + (a_M × b_M)·sinφ_M + a_M·((a_M · b_M)·(1 − cosφ_M)) + p_M + s_M", "1.5", [Length; 3];
            HitNormalShifted: "hit.normal", "shifted", "N", "N_M", "1.5", [One; 3];
            HitNormalTurned: "hit.normal", "turned", "N",
                "N_M·cosφ_M + (a_M × N_M)·sinφ_M + a_M·((a_M · N_M)·(1 − cosφ_M))", "1.5", [One; 3];
            HitGeometricNormalShifted: "hit.geometric_normal", "shifted", "N_g", "G_M", "1.5", [One; 3];
            HitGeometricNormalTurned: "hit.geometric_normal", "turned", "N_g",
                "G_M·cosφ_M + (a_M × G_M)·sinφ_M + a_M·((a_M · G_M)·(1 − cosφ_M))", "1.5", [One; 3];
            PatternPointFormless: "pattern.point", "", "P_p", "", "1.5", [Length; 3];
            PatternPointShifted: "pattern.point", "shifted_back", "P_p", "P − s_M", "1.5", [Length; 3];
            PatternPointTurned: "pattern.point", "turned_back", "P_p",
                "b_M·cosφ_M − (a_M × b_M)·sinφ_M + a_M·((a_M · b_M)·(1 − cosφ_M)) + p_M", "1.5", [Length; 3];
            PatternCellMoving: "pattern.cell", "moving", "ξ", "⌊P_p/s_p⌋", "1.5", [Count; 3];

            // A point of an area light, each with an equal share I_i of the light's intensity. κ_F draws the points together so
            // that they lie as dense as the profile says.
            LightSpread: "light.spread", "", "κ_F", "", "1.5", One;
            LightX: "light.x", "", "x_F", "(2·s_x − 1)·κ_F", "1.5", One;
            LightY: "light.y", "", "y_F", "(2·s_y − 1)·κ_F", "1.5", One;
            LightXOnDisk: "light.x", "round", "x_F", "x_D·κ_F", "1.5", One;
            LightYOnDisk: "light.y", "round", "y_F", "y_D·κ_F", "1.5", One;
            LightOutward: "light.outward", "", "ν_F", "(√(4·s_y·(1 − s_y))·cos(2π·s_x), √(4·s_y·(1 − s_y))·sin(2π·s_x), 1 − 2·s_y)", "1.5", [One; 3];
            // By solid angle the place of the point is an input, and the profile weighs its shadow ray.
            LightSolidAngle: "light.solid_angle", "", "Ω_F", "", "1.5", One;
            LightPositionOnArea: "light.position", "on_area", "F", "C_F + e_u·x_F + e_v·y_F", "1.5", [Length; 3];
            LightPositionOnSphere: "light.position", "on_sphere", "F", "C_F + ν_F·r_F", "1.5", [Length; 3];
            LightProfileCosine: "light.profile_cosine", "", "c_F", "", "1.5", One;
            LightProfilePower: "light.profile_power", "", "p_F", "", "1.5", One;
            LightProfileMean: "light.profile_mean", "", "m_F", "", "1.5", One;
            LightWeight: "light.weight", "", "w_F", "c_F^p_F/m_F", "1.5", One;
            LightColorWeighted: "light.color", "weighted", "I_i", "I_i·w_F", "1.5", [Intensity; 3];

            // A point of a rule of quadrature has its part of the mean for a weight.
            LightShare: "light.share", "", "w_Q", "", "1.5", One;
            LightColorShared: "light.color", "shared", "I_i", "I_i·w_Q", "1.5", [Intensity; 3];

            // A blurred bounce: directions of the lobe cosⁿ about M_z, which is R or T, in zones of equal probability.
            LobeMiddle: "lobe.middle", "", "M_z", "", "1.5", [One; 3];
            LobeExponent: "lobe.exponent", "", "n_z", "", "1.5", One;
            LobeHelper: "lobe.helper", "", "A_z", "", "1.5", [One; 3];
            LobeAxis1: "lobe.axis_1", "", "u_z", "(M_z × A_z)/|M_z × A_z|", "1.5", [One; 3];
            LobeAxis2: "lobe.axis_2", "", "w_z", "M_z × u_z", "1.5", [One; 3];
            LobeX: "lobe.x", "", "x_z", "√(−expm1(2·(ln1p(−s_y)/(n_z + 1))))·cos(2π·s_x)", "1.5", One;
            LobeY: "lobe.y", "", "y_z", "√(−expm1(2·(ln1p(−s_y)/(n_z + 1))))·sin(2π·s_x)", "1.5", One;
            LobeZ: "lobe.z", "", "z_z", "exp(ln1p(−s_y)/(n_z + 1))", "1.5", One;
            LobeDirection: "lobe.direction", "", "D_z", "u_z·x_z + w_z·y_z + M_z·z_z", "1.5", [One; 3];
            LobeHeight: "lobe.height", "", "h_z", "N · D_z", "1.5", One;
            LobeHeightGeometric: "lobe.height", "geometric", "h_z", "N_g · D_z", "1.5", One;
            LobeColor: "lobe.color", "", "I_z", "", "1.5", [Intensity; 3];
            LobeSumFirst: "lobe.sum", "first", "S_z", "I_z", "1.5", [Intensity; 3];
            LobeSum: "lobe.sum", "", "S_z", "S_z + I_z", "1.5", [Intensity; 3];
            LobeKept: "lobe.kept", "", "k_z", "", "1.5", Count;
            LobeMean: "lobe.mean", "", "m_z", "S_z/k_z", "1.5", [Intensity; 3];

            // The farther of two crossings, with twice the digits.
            SphereTDoubledFar: "sphere.t", "doubled_far", "t", "T_A + √T2_A", "1.3", Length;
            EllipsoidTDoubledFar: "ellipsoid.t", "doubled_far", "t", "(−b + √Δ)/a", "", Length;
            CylinderTDoubledFar: "cylinder.t", "doubled_far", "t", "(−b + √Δ)/a", "", Length;

            // The colour of a ray that hits nothing, and what the side of a pixel is made of.
            BackgroundColor: "background.color", "", "I_b", "", "", [Intensity; 3];
            CameraVerticalFov: "camera.vertical_fov", "", "θ_v", "", "", Degrees;
            CameraRows: "camera.rows", "", "n_v", "", "", Count;

            // The mean of samples: of n_p that count alike; of corners of cells, each w_s times; of cells, each with its area γ_c.
            SampleWeight: "sample.weight", "", "w_s", "", "1.4.2", One;
            PixelSamples: "pixel.samples", "", "n_p", "", "1.4.2", Count;
            CellArea: "cell.area", "", "γ_c", "", "1.4.2", One;
            PixelMean: "pixel.mean", "", "I_p", "Σ_s(I)/n_p", "1.4.2", [Intensity; 3];
            PixelMeanOfCorners: "pixel.mean", "of_corners", "I_p", "Σ_s(w_s·I)/n_p", "1.4.2", [Intensity; 3];
            PixelMeanOfCells: "pixel.mean", "of_cells", "I_p", "Σ_c(γ_c·(I_1 + I_2 + I_3 + I_4))/4", "1.4.2", [Intensity; 3];
        }
    };
}
