package lightning.render.gather.glow;

import lightning.render.gather.cell.Hash64;

/**
 * Directions of the rays that points aim at small glowing objects. Immutable.
 *
 * <p>A ray is aimed at a random place of those sides of the object's box that face the point. Each direction that meets the box passes
 * one of them, so a ray at distance d stands for the solid angle {@code A·cos α/d²} over the number of rays, where A is the area of these
 * sides and α the angle between the ray and the side's normal.
 */
public final class GlowAim {
    /** Parts of each cell of a box's side along each axis; neighboring points aim at different ones, as with {@link lightning.render.gather.cell.DirectionTable}. */
    private static final int PARTS = 4;
    private static final int MAX_SIDE = 2;

    private final GlowShapes shapes;
    /** Rays along each axis of a box's side. */
    private final int side;
    /** A point aims at one of so many objects, its neighbors at the others. */
    private final int turns;

    /** @param rays number of all aimed rays of a point, at most; 1 or more */
    public GlowAim(GlowShapes shapes, int rays) {
        this.shapes = shapes;
        int count = Math.max(1, shapes.count());
        side = count * MAX_SIDE * MAX_SIDE <= rays ? MAX_SIDE : 1;
        turns = Integer.highestOneBit(2 * Math.ceilDiv(count, rays) - 1);
    }

    /** Returns whether both cast as many rays to each object. */
    public boolean isAsDense(GlowAim other) {
        return side == other.side && turns == other.turns;
    }

    /**
     * Returns the number of rays that a point aims at an object.
     *
     * @param seed of the point's directions
     */
    public int rays(int shape, long seed, float x, float y, float z) {
        return (shapes.primitive(shape) + seed / (PARTS * PARTS) & turns - 1) == 0 && shapes.isSmall(shape, x, y, z) ? side * side : 0;
    }

    /**
     * Aims a ray of a point at an object.
     *
     * @param k         number of the ray
     * @param seed      of the point's directions
     * @param direction receives the direction, of length 1
     * @return the solid angle that the ray stands for, in units of π steradians; 0 if there is no ray
     */
    public double aim(int shape, int k, long seed, float x, float y, float z, double[] direction) {
        double[] from = {shapes.fromCenter(shape, 0, x), shapes.fromCenter(shape, 1, y), shapes.fromCenter(shape, 2, z)};
        double[] areas = {area(shape, 0, from), area(shape, 1, from), area(shape, 2, from)};
        double area = areas[0] + areas[1] + areas[2];
        if (!(area > 0)) {
            return 0;
        }
        long random = Hash64.mix(seed + k * 0x9e3779b97f4a7c15L);
        double u = coordinate(k % side, seed, random);
        double v = coordinate(k / side, seed / PARTS, random >>> 24);
        double rest = u * area;
        int axis = rest < areas[0] ? 0 : rest < areas[0] + areas[1] ? 1 : 2;
        rest -= axis == 0 ? 0 : axis == 1 ? areas[0] : areas[0] + areas[1];
        double[] place = new double[3];
        place[axis] = Math.signum(from[axis]);
        place[(axis + 1) % 3] = 2 * rest / areas[axis] - 1;
        place[(axis + 2) % 3] = 2 * v - 1;
        double squared = 0;
        for (int i = 0; i < 3; i++) {
            direction[i] = place[i] * shapes.halfSide(shape, i) - from[i];
            squared += direction[i] * direction[i];
        }
        double length = Math.sqrt(squared);
        for (int i = 0; i < 3; i++) {
            direction[i] /= length;
        }
        return area * Math.abs(direction[axis]) * turns / (Math.PI * side * side * squared);
    }

    /**
     * Returns the solid angle that a ray stands for which is aimed at an object in some direction, in units of π steradians; 0 if none is.
     *
     * @param direction of length 1, which meets the object
     */
    public double solidAngle(int shape, float x, float y, float z, double[] direction) {
        if (!shapes.isSmall(shape, x, y, z)) {
            return 0;
        }
        double[] from = {shapes.fromCenter(shape, 0, x), shapes.fromCenter(shape, 1, y), shapes.fromCenter(shape, 2, z)};
        double area = 0;
        double length = 0;
        double cosine = 0;
        for (int axis = 0; axis < 3; axis++) {
            double its = area(shape, axis, from);
            area += its;
            double entry = (Math.signum(from[axis]) * shapes.halfSide(shape, axis) - from[axis]) / direction[axis];
            if (its > 0 && entry > length) {
                length = entry;
                cosine = Math.abs(direction[axis]);
            }
        }
        return length > 0 ? area * cosine * turns / (Math.PI * side * side * (length * length)) : 0;
    }

    /** Returns a coordinate 0…1 in a cell of a box's side: in the part of the lowest two bits of {@code part}, at a random place. */
    private double coordinate(int cell, long part, long random) {
        return (cell + ((part & PARTS - 1) + (random & 0xffffff) * 0x1p-24) / PARTS) / side;
    }

    /** Returns the area of the side across an axis that faces a place, relative to the center; 0 if none does. */
    private double area(int shape, int axis, double[] from) {
        return Math.abs(from[axis]) > shapes.halfSide(shape, axis)
                ? 4 * shapes.halfSide(shape, (axis + 1) % 3) * shapes.halfSide(shape, (axis + 2) % 3) : 0;
    }
}
