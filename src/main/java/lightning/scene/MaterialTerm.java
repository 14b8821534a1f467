package lightning.scene;

/** What of the picture's rows a material's attribute changes. */
public enum MaterialTerm {
    /** Which attributes act, and with them each light's diffuse and specular terms. */
    MODEL,
    /** A factor that the equation is closed with: no row keeps anything of it. */
    COLOR,
    /** Each light's specular term, where highlights are. */
    HIGHLIGHT,
    /** The texel of each row, and the color with it. */
    TEXEL,
    /** Which rows there are: where the surface is at all. */
    COVERAGE,
    /** The normal of each row, and all that follows from it. */
    NORMAL,
    /** Which way rays go on behind the surface. */
    REFRACTION,
    /** Which ways to lights are blocked. */
    SHADOW
}
