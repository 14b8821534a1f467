package lightning.scene;

/** One entry of the scene's tree: a shape, or a group that places several nodes together. */
public sealed interface Node permits Shape, Group {
    /** Unique among all shapes, groups and lights. */
    String name();

    Placement placement();
}
