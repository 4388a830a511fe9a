//! The named quantities: their keys in a log, their symbols and formulas on paper, and where the source text has them.
//!
//! One row a quantity; those of the shapes are in `name/shapes.rs`, those of distributed effects in `name/effects.rs`. Adding a
//! logged quantity is one row here and one `note` in the kernel that computes it. A formula is written with the symbols of this same table (see [`super::formula`] for its grammar), and a test evaluates every
//! formula on the logged operands and must get the logged value. An event has its inputs in the order of this table, so that
//! their order in a file doesn't matter: a row is behind those of the inputs that are given before it.

#[macro_use]
mod row;
#[macro_use]
mod effects;
#[macro_use]
mod shapes;
mod unit;

use row::Row;
pub use unit::Unit;

with_shapes! { names! {
    // The camera and its ray. G is the direction of view, e_x and e_y point right and up in the picture.
    RayOrigin: "ray.origin", "", "O", "", "", [Length; 3];
    CameraDirection: "camera.direction", "", "G", "", "", [Length; 3];
    CameraUpAsGiven: "camera.up_as_given", "", "G_u", "", "", [One; 3];
    CameraLength: "camera.length", "", "|G|", "√(G · G)", "", Length;
    CameraRight: "camera.right", "", "e_x", "(G×G_u)/|G×G_u|", "", [One; 3];
    CameraUp: "camera.up", "", "e_y", "((G×G_u)×G)/|(G×G_u)×G|", "", [One; 3];
    PixelColumn: "pixel.column", "", "col", "", "", Pixels;
    PixelMiddleColumn: "pixel.middle_column", "", "col_m", "", "", Pixels;
    PixelRow: "pixel.row", "", "row", "", "", Pixels;
    PixelMiddleRow: "pixel.middle_row", "", "row_m", "", "", Pixels;
    PixelSide: "pixel.side", "", "px", "2·tan(θ_v°/2)/n_v", "", PerPixel;
    PixelX: "pixel.x", "", "x", "(col − col_m)·px", "", One;
    PixelY: "pixel.y", "", "y", "(row_m − row)·px", "", One;
    RayVector: "ray.vector", "", "D", "G + |G|·(x·e_x + y·e_y)", "", [Length; 3];
    RayLength: "ray.length", "", "|D|", "√(D · D)", "1.3", Length;
    RayDirection: "ray.direction", "", "d", "D/|D|", "1.3", [One; 3];
} {
    // The nearest hit: its point, and the normal turned toward the arriving ray.
    HitPoint: "hit.point", "", "P", "O + d·t", "1.3", [Length; 3];
    HitPointSphere: "hit.point", "on_sphere", "P", "S_c + q_s·(r/|q_s|)", "1.3", [Length; 3];
    HitPointEllipsoid: "hit.point", "on_ellipsoid", "P", "E_c + (p_e − g_e·(f_e/(2·(g_e · g_e))))", "", [Length; 3];
    HitPointCylinder: "hit.point", "on_cylinder", "P", "A_b + w·p_w + p_r·(r/|p_r|)", "", [Length; 3];
    HitPointCone: "hit.point", "on_cone", "P", "A_b + (p_b − g_c·(f_c/(g_c · g_c)))", "", [Length; 3];
    HitPointBaseCap: "hit.point", "on_base_cap", "P", "A_b + p_r", "", [Length; 3];
    HitPointApexCap: "hit.point", "on_apex_cap", "P", "A_a + p_r", "", [Length; 3];
    HitNormalPlane: "hit.normal", "plane", "N", "N_p/|N_p|", "1.3", [One; 3];
    HitNormalPlaneBack: "hit.normal", "plane_back", "N", "−(N_p/|N_p|)", "1.3", [One; 3];
    HitNormalFacing: "hit.normal", "facing", "N", "−d", "", [One; 3];
    HitNormalSphere: "hit.normal", "sphere", "N", "(P − S_c)/r", "1.3", [One; 3];
    HitNormalSphereBack: "hit.normal", "sphere_back", "N", "(S_c − P)/r", "1.3", [One; 3];
    HitNormalOnSphere: "hit.normal", "on_sphere", "N", "q_s/|q_s|", "1.3", [One; 3];
    HitNormalOnSphereBack: "hit.normal", "on_sphere_back", "N", "−q_s/|q_s|", "1.3", [One; 3];
    HitNormalEllipsoid: "hit.normal", "ellipsoid", "N", "g_e/|g_e|", "", [One; 3];
    HitNormalEllipsoidBack: "hit.normal", "ellipsoid_back", "N", "−g_e/|g_e|", "", [One; 3];
    HitNormalCylinder: "hit.normal", "cylinder", "N", "p_r/|p_r|", "", [One; 3];
    HitNormalCylinderBack: "hit.normal", "cylinder_back", "N", "−p_r/|p_r|", "", [One; 3];
    HitNormalCone: "hit.normal", "cone", "N", "g_c/|g_c|", "", [One; 3];
    HitNormalConeBack: "hit.normal", "cone_back", "N", "−g_c/|g_c|", "", [One; 3];
    HitNormalAlongAxis: "hit.normal", "along_axis", "N", "w", "", [One; 3];
    HitNormalAgainstAxis: "hit.normal", "against_axis", "N", "−w", "", [One; 3];
    HitNormalTriangle: "hit.normal", "triangle", "N", "ν_t", "", [One; 3];
    HitNormalTriangleBack: "hit.normal", "triangle_back", "N", "−ν_t", "", [One; 3];
    HitNormalPolygon: "hit.normal", "polygon", "N", "ν_q", "", [One; 3];
    HitNormalPolygonBack: "hit.normal", "polygon_back", "N", "−ν_q", "", [One; 3];
    HitNormalBox: "hit.normal", "box", "N", "ν_b", "", [One; 3];
    HitNormalBoxBack: "hit.normal", "box_back", "N", "−ν_b", "", [One; 3];
    HitNormalDisk: "hit.normal", "disk", "N", "ν_d", "", [One; 3];
    HitNormalDiskBack: "hit.normal", "disk_back", "N", "−ν_d", "", [One; 3];
    // Where normals are interpolated, the surface's own one has a name of its own, and the mean lies on its side.
    HitGeometricNormalTriangle: "hit.geometric_normal", "triangle", "N_g", "ν_t", "", [One; 3];
    HitGeometricNormalTriangleBack: "hit.geometric_normal", "triangle_back", "N_g", "−ν_t", "", [One; 3];
    HitGeometricNormalPolygon: "hit.geometric_normal", "polygon", "N_g", "ν_q", "", [One; 3];
    HitGeometricNormalPolygonBack: "hit.geometric_normal", "polygon_back", "N_g", "−ν_q", "", [One; 3];
    HitNormalMean: "hit.normal", "mean", "N", "N_m/|N_m|", "", [One; 3];
    HitNormalMeanTurned: "hit.normal", "mean_turned", "N", "−N_m/|N_m|", "", [One; 3];
    HitNormalFlat: "hit.normal", "flat", "N", "N_g", "", [One; 3];

    // The two bounces.
    ReflectDirection: "reflect.direction", "", "R", "d − 2·N·(d · N)", "1.2.2", [One; 3];
    // Of the notes, by which every new direction is normalised. The length has no name of its own, so that nothing rounds it.
    ReflectDirectionNormalized: "reflect.direction", "normalized", "R",
        "(d − 2·N·(d · N))/|d − 2·N·(d · N)|", "1.2.2", [One; 3];
    ReflectDirectionBent: "reflect.direction", "bent", "R", "(R − N_g·(R · N_g))/|R − N_g·(R · N_g)|", "1.2.2", [One; 3];
    RefractEta1: "refract.eta_1", "", "η_1", "", "1.2.1", One;
    RefractEta2: "refract.eta_2", "", "η_2", "", "1.2.1", One;
    RefractEta: "refract.eta", "", "η", "η_2/η_1", "1.2.1", One;
    RefractCos1: "refract.cos_1", "", "cosφ_1", "−(N · d)", "1.2.1", One;
    RefractCos2: "refract.cos_2", "", "cosφ_2", "√(η² − |d + cosφ_1·N|²)/η", "1.2.1", One;
    RefractCos2Printed: "refract.cos_2", "notes", "cosφ_2", "√(1 − (1 − cosφ_1²)/η²)", "1.2.1", One;
    RefractCos2Doubled: "refract.cos_2", "doubled", "cosφ_2", "√(1 − |d × N|²/((d · d)·(N · N)·η²))", "1.2.1", One;
    RefractDirection: "refract.direction", "", "T", "d/η − (cosφ_2 − cosφ_1/η)·N", "1.2.1", [One; 3];
    RefractDirectionNormalized: "refract.direction", "normalized", "T",
        "(d/η − (cosφ_2 − cosφ_1/η)·N)/|d/η − (cosφ_2 − cosφ_1/η)·N|", "1.2.1", [One; 3];
    RefractDirectionBent: "refract.direction", "bent", "T", "(T − N_g·(T · N_g))/|T − N_g·(T · N_g)|", "1.2.1", [One; 3];

    // A light as a surface point sees it. ℓ is not normalised, L is.
    LightPosition: "light.position", "", "F", "", "1.3", [Length; 3];
    LightTravel: "light.travel", "", "u", "", "1.2.1", [One; 3];
    LightCenter: "light.center", "", "C_F", "", "1.5", [Length; 3];
    LightEdgeU: "light.edge_u", "", "e_u", "", "1.5", [Length; 3];
    LightEdgeV: "light.edge_v", "", "e_v", "", "1.5", [Length; 3];
    LightRadius: "light.radius", "", "r_F", "", "1.5", Length;
    LightColor: "light.color", "", "I_i", "", "1.2.1", [Intensity; 3];
    LightConstant: "light.constant", "", "a_c", "", "1.2.1", One;
    LightLinear: "light.linear", "", "a_l", "", "1.2.1", PerLength;
    LightQuadratic: "light.quadratic", "", "a_q", "", "1.2.1", PerArea;
    LightVector: "light.vector", "", "ℓ", "F − P", "1.3", [Length; 3];
    LightDistance: "light.distance", "", "|ℓ|", "√(ℓ · ℓ)", "1.3", Length;
    LightDirection: "light.direction", "", "L", "ℓ/|ℓ|", "1.3", [One; 3];
    LightDirectionFixed: "light.direction", "directional", "L", "−u", "1.2.1", [One; 3];
    LightAttenuation: "light.attenuation", "", "att", "min(1, 1/(a_c + a_l·|ℓ| + a_q·|ℓ|²))", "1.2.1", One;
    ShadowTransmittance: "shadow.transmittance", "", "τ", "Π(W_t)", "1.2.5", [One; 3];

    // The local model, in H form and in R form, and its transmitted term.
    ViewDirection: "view.direction", "", "V", "−d", "1.3", [One; 3];
    HalfSum: "half.sum", "", "h", "L + V", "1.3", [One; 3];
    HalfLength: "half.length", "", "|h|", "√(h · h)", "1.3", One;
    HalfDirection: "half.direction", "", "H", "h/|h|", "1.3", [One; 3];
    MirrorDirection: "mirror.direction", "", "R_L", "2·N·N·L − L", "1.2.1", [One; 3];
    TransmitEta: "transmit.eta", "", "η_t", "η_2/η_1", "1.2.1", One;
    TransmitSum: "transmit.sum", "", "h′", "−(L + V)/(η_t − 1) − V", "1.2.1", [One; 3];
    // As the notes print it; their second form, with η = η_1/η_2 and L for the incident direction, is the same vector.
    TransmitSumPrinted: "transmit.sum", "notes", "h′", "(−L − η_t·V)/(η_t − 1)", "1.2.1", [One; 3];
    TransmitLength: "transmit.length", "", "|h′|", "√(h′ · h′)", "1.2.1", One;
    TransmitDirection: "transmit.direction", "", "H′", "h′/|h′|", "1.2.1", [One; 3];
    ShadeNDotL: "shade.n_dot_l", "", "N·L", "N · L", "1.3", One;
    ShadeNDotH: "shade.n_dot_h", "", "N·H", "N · H", "1.3", One;
    ShadeRDotV: "shade.r_dot_v", "", "R·V", "R_L · V", "1.2.1", One;
    ShadeNDotTransmitted: "shade.n_dot_transmitted", "", "−N·H′", "−(N · H′)", "1.2.1", One;
    ShadeNDotTransmittedStraight: "shade.n_dot_transmitted", "no_interface", "−N·H′", "1", "1.2.1", One;
    // Powers of large exponents are taken from the angle itself: near 1 its cosine has lost it.
    ShadeSpecularPower: "shade.specular_power", "", "π_e", "((N·H)⁺)^n_e", "1.2.1", One;
    ShadeSpecularPowerCompensated: "shade.specular_power", "compensated", "π_e", "((N·H)⁺)^(4·n_e)", "1.2.1", One;
    ShadeSpecularPowerMirror: "shade.specular_power", "reflection_vector", "π_e", "((R·V)⁺)^n_e", "1.2.1", One;
    ShadeSpecularPowerSine: "shade.specular_power", "sine", "π_e",
        "exp(n_e/2·ln1p(−min(|H × (N − H)|²/((H · H)·(N · N)), 1)))", "1.2.1", One;
    ShadeSpecularPowerCompensatedSine: "shade.specular_power", "compensated_sine", "π_e",
        "exp(4·n_e/2·ln1p(−min(|H × (N − H)|²/((H · H)·(N · N)), 1)))", "1.2.1", One;
    ShadeSpecularPowerMirrorSine: "shade.specular_power", "reflection_vector_sine", "π_e",
        "exp(n_e/2·ln1p(−min(|R_L × (V − R_L)|²/((R_L · R_L)·(V · V)), 1)))", "1.2.1", One;
    ShadeTransmittedPower: "shade.transmitted_power", "", "π_t", "((−N·H′)⁺)^n_t", "1.2.1", One;
    ShadeTransmittedPowerSine: "shade.transmitted_power", "sine", "π_t",
        "exp(n_t/2·ln1p(−min(|N × (H′ + N)|²/((N · N)·(H′ · H′)), 1)))", "1.2.1", One;
    AmbientLight: "light.ambient", "", "I_a", "", "1.2.1", [Intensity; 3];
    MaterialAmbient: "material.ambient", "", "K_a", "", "1.2.1", [One; 3];
    MaterialAmbientPatterned: "material.ambient", "patterned", "K_a", "k_a∘c_p", "1.2.1", [One; 3];
    MaterialDiffuse: "material.diffuse", "", "K_d", "", "1.2.1", [One; 3];
    MaterialDiffusePatterned: "material.diffuse", "patterned", "K_d", "k_d∘c_p", "1.2.1", [One; 3];
    MaterialSpecular: "material.specular", "", "K_e", "", "1.2.1", [One; 3];
    MaterialShininess: "material.shininess", "", "n_e", "", "1.2.1", One;
    MaterialTransmission: "material.transmission", "", "K_t", "", "1.2.1", [One; 3];
    MaterialTransmissionExponent: "material.transmission_exponent", "", "n_t", "", "1.2.1", One;
    WeightLocal: "weight.local", "", "W_l", "", "1.2.3", [One; 3];
    ShadeLocal: "shade.local", "", "I_local",
        "I_a∘K_a + Σ(I_i·att∘τ∘(K_d·(N·L)⁺ + K_e·((N·H)⁺)^n_e))", "1.2.1", [Intensity; 3];
    ShadeLocalMirror: "shade.local", "reflection_vector", "I_local",
        "I_a∘K_a + Σ(I_i·att∘τ∘(K_d·(N·L)⁺ + K_e·((R·V)⁺)^n_e))", "1.2.1", [Intensity; 3];
    // The angle between N and H is half of that between R and V: with 4n the highlights are as wide.
    ShadeLocalCompensated: "shade.local", "compensated", "I_local",
        "I_a∘K_a + Σ(I_i·att∘τ∘(K_d·(N·L)⁺ + K_e·((N·H)⁺)^(4·n_e)))", "1.2.1", [Intensity; 3];
    ShadeLocalCompensatedTransmitting: "shade.local", "compensated_transmitting", "I_local",
        "I_a∘K_a + Σ(I_i·att∘τ∘(K_d·(N·L)⁺ + K_e·((N·H)⁺)^(4·n_e) + K_t·((−N·H′)⁺)^n_t))", "1.2.1", [Intensity; 3];
    ShadeLocalTransmitting: "shade.local", "transmitting", "I_local",
        "I_a∘K_a + Σ(I_i·att∘τ∘(K_d·(N·L)⁺ + K_e·((N·H)⁺)^n_e + K_t·((−N·H′)⁺)^n_t))", "1.2.1", [Intensity; 3];
    ShadeLocalMirrorTransmitting: "shade.local", "reflection_vector_transmitting", "I_local",
        "I_a∘K_a + Σ(I_i·att∘τ∘(K_d·(N·L)⁺ + K_e·((R·V)⁺)^n_e + K_t·((−N·H′)⁺)^n_t))", "1.2.1", [Intensity; 3];
    ShadeLocalSharp: "shade.local", "sharp", "I_local",
        "I_a∘K_a + Σ(I_i·att∘τ∘(K_d·(N·L)⁺ + K_e·π_e))", "1.2.1", [Intensity; 3];
    ShadeLocalSharpTransmitting: "shade.local", "sharp_transmitting", "I_local",
        "I_a∘K_a + Σ(I_i·att∘τ∘(K_d·(N·L)⁺ + K_e·π_e + K_t·π_t))", "1.2.1", [Intensity; 3];
    ShadeLocalAmbient: "shade.local", "ambient", "I_local", "I_a∘K_a", "1.1.2", [Intensity; 3];

    // A checker pattern. m_p is 1 on the axes that count: all of them, but on a flat surface not the one nearest to its
    // normal. ξ is the cell of the point; the colour is c_a where the sum of its coordinates is even, c_b where it is odd.
    MaterialAmbientPlain: "material.ambient_plain", "", "k_a", "", "1.2.1", [One; 3];
    MaterialDiffusePlain: "material.diffuse_plain", "", "k_d", "", "1.2.1", [One; 3];
    PatternA: "pattern.a", "", "c_a", "", "1.2.1", [One; 3];
    PatternB: "pattern.b", "", "c_b", "", "1.2.1", [One; 3];
    PatternSize: "pattern.size", "", "s_p", "", "1.2.1", Length;
    PatternAxes: "pattern.axes", "", "m_p", "", "1.2.1", [Count; 3];
    PatternCell: "pattern.cell", "", "ξ", "⌊P/s_p⌋", "1.2.1", [Count; 3];
    PatternSum: "pattern.sum", "", "σ", "m_p · ξ", "1.2.1", Count;
    PatternParity: "pattern.parity", "", "π", "σ − 2·⌊σ/2⌋", "1.2.1", Count;
    PatternColorEven: "pattern.color", "even", "c_p", "c_a", "1.2.1", [One; 3];
    PatternColorOdd: "pattern.color", "odd", "c_p", "c_b", "1.2.1", [One; 3];

    // The sum of the three contributions.
    // What the bounce at a cutoff could have added to the sample at most: no arithmetic rounds it.
    CutoffLoss: "cutoff.loss", "", "ΔI", "", "", [Intensity; 3];
    WeightReflected: "weight.reflected", "", "W_r", "", "1.2.3", [One; 3];
    WeightTransmitted: "weight.transmitted", "", "W_t", "", "1.2.3", [One; 3];
    IncomingReflected: "incoming.reflected", "", "I_reflected", "", "1.2.3", [Intensity; 3];
    IncomingTransmitted: "incoming.transmitted", "", "I_transmitted", "", "1.2.3", [Intensity; 3];
    CombineLocal: "combine.local", "", "C_l", "W_l∘I_local", "1.2.3", [Intensity; 3];
    CombineReflected: "combine.reflected", "", "C_r", "W_r∘I_reflected", "1.2.3", [Intensity; 3];
    CombineReflectedSpecular: "combine.reflected", "specular", "C_r", "W_r∘K_e∘I_reflected", "1.1.2", [Intensity; 3];
    CombineTransmitted: "combine.transmitted", "", "C_t", "W_t∘I_transmitted", "1.2.3", [Intensity; 3];
    CombineColor: "combine.color", "", "I", "C_l + C_r + C_t", "1.2.3", [Intensity; 3];

    // The place of a random point in the unit square, a sample's in its pixel or that of a split: in stratum i_s of the c_s of its row, a_s of all n_s lying in the rows above.
    SampleColumn: "sample.column", "", "i_s", "", "1.5", Count;
    SampleJitterX: "sample.jitter_x", "", "ξ_x", "", "1.5", One;
    SampleAcross: "sample.across", "", "c_s", "", "1.5", Count;
    SampleAbove: "sample.above", "", "a_s", "", "1.5", Count;
    SampleJitterY: "sample.jitter_y", "", "ξ_y", "", "1.5", One;
    SampleCount: "sample.count", "", "n_s", "", "1.5", Count;
    SampleX: "sample.x", "", "s_x", "(i_s + ξ_x)/c_s", "1.5", One;
    SampleY: "sample.y", "", "s_y", "(a_s + ξ_y·c_s)/n_s", "1.5", One;
    PixelLeft: "pixel.left", "", "col_0", "", "1.4.2", Pixels;
    PixelTop: "pixel.top", "", "row_0", "", "1.4.2", Pixels;
    PixelColumnSampled: "pixel.column", "sampled", "col", "col_0 + s_x", "1.4.2", Pixels;
    PixelRowSampled: "pixel.row", "sampled", "row", "row_0 + s_y", "1.4.2", Pixels;

    // Adaptive sampling: the colours at the corners of a cell, and the figures by which it is cut.
    CellColor1: "cell.color_1", "", "I_1", "", "1.4.2", [Intensity; 3];
    CellColor2: "cell.color_2", "", "I_2", "", "1.4.2", [Intensity; 3];
    CellColor3: "cell.color_3", "", "I_3", "", "1.4.2", [Intensity; 3];
    CellColor4: "cell.color_4", "", "I_4", "", "1.4.2", [Intensity; 3];
    CellThreshold: "cell.threshold", "", "θ", "", "1.4.2", One;
    CellLimit: "cell.limit", "", "Δ_max", "θ·w_o", "1.4.2", Intensity;
    CellDifference: "cell.difference", "", "Δ_I",
        "max(max(max(I_1, I_2), max(I_3, I_4)) − min(min(I_1, I_2), min(I_3, I_4)))", "1.4.2", Intensity;
} }

#[cfg(test)]
mod tests;
