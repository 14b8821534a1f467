package lightning.scene;

/** What of the picture's rows a material's attribute changes. */
public enum MaterialTerm {
    /** A factor that the equation is closed with: no row keeps anything of it. */
    COLOR,
    /** Each light's specular term, where highlights are. */
    HIGHLIGHT,
    /** The texel of each row, and the colour with it. */
    TEXEL
}
