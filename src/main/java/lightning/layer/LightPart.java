package lightning.layer;

/** Part of the light of some lights, in the order of the layers. */
enum LightPart {
    /** Diffuse term on directly visible surfaces. */
    DIFFUSE,
    /** Specular term on directly visible surfaces. */
    SPECULAR,
    /** Light that directly visible surfaces get or reflect by way of other surfaces, along gathered paths. */
    GATHERED,
    /** What mirrors and transparent surfaces show of it. */
    REFLECTIONS,
    /** What the fog before directly visible surfaces scatters of it. */
    FOG
}
