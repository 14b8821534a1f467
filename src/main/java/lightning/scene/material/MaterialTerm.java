package lightning.scene.material;

/** Part of the shading points that a material's attribute changes. */
public enum MaterialTerm {
    /** Active attributes, and with them each light's diffuse and specular terms. */
    MODEL,
    /** Factor applied last; not cached in any row. */
    COLOR,
    /** Specular term of each light, within highlights. */
    HIGHLIGHT,
    /** Texel of each row, and its color. */
    TEXEL,
    /** Texel of each row, and with it the specular term of each light and the color. */
    HIGHLIGHT_TEXEL,
    /** Set of rows: the extent of the surface. */
    COVERAGE,
    /** Normal of each row, and all values that depend on it. */
    NORMAL,
    /** Direction of rays after the surface. */
    REFRACTION,
    /** Occlusion of shadow rays. */
    SHADOW;

    /** Returns whether it includes the texels of rows. */
    public boolean changesTexels() {
        return this == TEXEL || this == HIGHLIGHT_TEXEL;
    }
}
