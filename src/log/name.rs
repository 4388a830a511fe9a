//! The named quantities: their keys in a log, their symbols and formulas on paper, and where the source text has them.
//!
//! One row a quantity; those of the shapes are in `name/shapes.rs`, those of distributed effects in `name/effects.rs`. Adding a logged quantity is one row here and one `note` in the kernel that computes it. A formula
//! is written with the symbols of this same table (see [`super::formula`] for its grammar), and a test evaluates every
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
} {
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
