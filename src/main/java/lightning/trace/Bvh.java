package lightning.trace;

/** The tree of boxes over the shapes. */
final class Bvh {
    Bvh(ShapeTable shapes) {}
}
