package lightning.scene.material;

/**
 * Normals of a coat that are not those of the surface below.
 *
 * @param map     normal map of the coat; flat for a smooth coat over a bumped surface
 * @param mirrors whether mirrored rays follow them
 */
public record CoatNormals(BumpMapping map, boolean mirrors) {
    /** The coat has the normals of the surface, or there is none. */
    public static final CoatNormals NONE = new CoatNormals(BumpMapping.NONE, false);

    /** Returns whether both give every surface the same normals. */
    public boolean areSame(CoatNormals o) {
        return this == o || this != NONE && o != NONE && mirrors == o.mirrors && map.hasSameNormals(o.map);
    }
}
