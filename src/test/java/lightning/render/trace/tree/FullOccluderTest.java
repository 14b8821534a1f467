package lightning.render.trace.tree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.List;
import java.util.Random;
import lightning.base.math.Vec3;
import lightning.render.engine.Engine;
import lightning.render.engine.choice.Engines;
import lightning.render.trace.Geometry;
import lightning.render.trace.HitRows;
import lightning.render.trace.LocalSpace;
import lightning.render.trace.ShadowRays;
import lightning.render.trace.TexelColumns;
import lightning.render.trace.TraceScenes;
import lightning.render.trace.primitive.PrimitiveTable;
import lightning.render.trace.solid.SolidKind;
import lightning.scene.node.Solid;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;

/** Tests that a reported full occluder blocks all shadow rays, with every rounding error, on every engine. */
class FullOccluderTest {
    private static final int ROWS = 16;
    private final FullOcclusionTest occlusionTest = new FullOcclusionTest();

    /**
     * Uses solids of scales from 10⁻⁹ to 10⁹, stretched and moved, with rows in single precision. Shadow rays from 10⁻⁴ to 10⁹
     * of their sizes pass a solid's surface at depths from 10⁻¹⁷ to 1 or just outside it. Blocks of rows are a point or up to
     * as large as the solid.
     */
    @Property
    void fullOccluder_blocksAllShadowRaysOnEveryEngine(@ForAll long seed) {
        Geometry geometry = Geometry.of(switch (Math.floorMod(seed, 3)) {
            case 0 -> TraceScenes.randomScene(3, seed);
            case 1 -> TraceScenes.skewedShapes(3, seed);
            default -> TraceScenes.cloud(3, seed);
        });
        PrimitiveTable primitives = geometry.primitives();
        Random random = new Random(seed);
        for (int bundle = 0; bundle < 60; bundle++) {
            int s = random.nextInt(primitives.count);
            if (primitives.mesh(s) == null) {
                assertBlocked(geometry, s, new ShadowRayBundle(primitives, s, random));
            }
        }
    }

    private void assertBlocked(Geometry geometry, int s, ShadowRayBundle bundle) {
        boolean ends = bundle.toPoints;
        ShadowRays[] shadowRays = Arrays.stream(bundle.targets)
                .map(t -> ends ? ShadowRays.toPoint(geometry.shadowRayTarget(t)) : ShadowRays.inDirection(t)).toArray(ShadowRays[]::new);
        occlusionTest.setRays(bundle.box(), bundle.center, bundle.extent, ends,
                p -> Arrays.stream(shadowRays).anyMatch(w -> w.target().indexOf(p) >= 0));
        if (occlusionTest.isFullOccluder(geometry.primitives(), s)) {
            CandidateList alone = onlyPrimitive(geometry, s);
            for (Engine engine : List.of(Engines.SCALAR, Engines.LANES)) {
                for (ShadowRays direction : shadowRays) {
                    int[] blocked = new int[1];
                    engine.tracer(geometry).findBlocked(bundle.rows, new int[] {(1 << ROWS) - 1}, direction, alone, blocked);
                    assertThat(blocked[0]).as("%s of kind %s", engine, geometry.primitives().kind(s)).isEqualTo((1 << ROWS) - 1);
                }
            }
        }
    }

    private static CandidateList onlyPrimitive(Geometry geometry, int s) {
        boolean[] selected = new boolean[geometry.primitiveCount()];
        selected[s] = true;
        return CandidateList.fromBvh(geometry.bvh(), selected);
    }

    /** Rows of a block and positions of a light, with shadow rays past the surface of a primitive. */
    private static final class ShadowRayBundle {
        private final HitRows rows = new HitRows(ROWS, TexelColumns.NONE);
        private final boolean toPoints;
        private final Vec3[] targets;
        private final Vec3 center;
        private final double extent;

        ShadowRayBundle(PrimitiveTable primitives, int s, Random random) {
            toPoints = random.nextInt(3) > 0;
            Vec3 in = inside(primitives.kind(s), random);
            Vec3 along = unit(random);
            if (random.nextBoolean()) {
                // Along the surface instead of through it.
                along = new Vec3(-in.z(), random.nextInt(2) * along.y(), in.x());
            }
            Vec3 from = in.minus(along.times(randomPower(random, -4, 7)));
            double spread = random.nextInt(3) == 0 ? 0 : randomPower(random, -12, 0);
            rows.count = ROWS;
            for (int i = 0; i < ROWS; i++) {
                Vec3 p = LocalSpace.toRender(primitives, s, from.plus(unit(random).times(spread)));
                rows.px[i] = (float) p.x();
                rows.py[i] = (float) p.y();
                rows.pz[i] = (float) p.z();
            }
            // Aimed from a row as stored, so that it passes the intended point.
            Vec3 origin = LocalSpace.toLocal(primitives, s, new Vec3(rows.px[0], rows.py[0], rows.pz[0]));
            Vec3 direction = in.minus(origin).times(1 + randomPower(random, -4, 6));
            center = toPoints ? LocalSpace.toRender(primitives, s, origin.plus(direction))
                    : LocalSpace.toRender(primitives, s, direction).minus(LocalSpace.toRender(primitives, s, Vec3.ZERO))
                            .times(randomPower(random, -9, 9));
            Vec3 edge = toPoints
                    ? LocalSpace.toRender(primitives, s, origin.plus(direction).plus(unit(random).times(randomPower(random, -12, 0))))
                    : center;
            extent = random.nextBoolean() ? 0 : toPoints ? edge.minus(center).length() : center.length() * randomPower(random, -12, -1);
            targets = new Vec3[extent == 0 ? 1 : 4];
            Arrays.setAll(targets, i -> i == 0 ? center : center.plus(unit(random).times(extent * (1 - 0x1p-40))));
        }

        PointBox box() {
            PointBox box = new PointBox();
            float[][] points = {rows.px, rows.py, rows.pz};
            for (int axis = 0; axis < 3; axis++) {
                float low = points[axis][0];
                float high = low;
                for (int i = 1; i < ROWS; i++) {
                    low = Math.min(low, points[axis][i]);
                    high = Math.max(high, points[axis][i]);
                }
                box.set(axis, low, high);
            }
            return box;
        }

        /** Returns a local point near the surface of a canonical solid: slightly or far inside, or outside. */
        private static Vec3 inside(SolidKind kind, Random random) {
            double depth = (random.nextInt(4) == 0 ? -1 : 1) * randomPower(random, -17, 0);
            Vec3 u = unit(random);
            if (kind == SolidKind.SPHERE) {
                return u.times(1 - depth);
            }
            double height = random.nextInt(3) == 0 ? depth : random.nextInt(2) == 0 ? 1 - depth : random.nextDouble();
            double ring = random.nextInt(3) == 0 ? random.nextDouble() : 1 - depth;
            double length = Math.hypot(u.x(), u.z());
            return new Vec3(u.x() / length * ring, height, u.z() / length * ring);
        }

        private static Vec3 unit(Random random) {
            Vec3 v = new Vec3(random.nextGaussian(), random.nextGaussian(), random.nextGaussian());
            return v.times(1 / v.length());
        }

        /** Returns ten to a power between two values. */
        private static double randomPower(Random random, double least, double most) {
            return Math.pow(10, least + (most - least) * random.nextDouble());
        }
    }

    @Test
    void ballBetweenRowsAndLight_isFullOccluder() {
        assertThat(ballBlocks(new Vec3(0, 4, -5), 0, true)).isTrue();
        assertThat(ballBlocks(new Vec3(0, 4, -5), 0.3, true)).isTrue();
        assertThat(ballBlocks(new Vec3(0, 1, 0), 0, false)).isTrue();
    }

    /** A light of radius 2.5, three units above the center of the ball, is visible past it from below. */
    @Test
    void ballSmallerThanLight_isNoFullOccluder() {
        assertThat(ballBlocks(new Vec3(0, 4, -5), 2.5, true)).isFalse();
        assertThat(ballBlocks(new Vec3(1, 0, 0), 0, false)).isFalse();
        assertThat(ballBlocks(new Vec3(3, 0, -5), 0, true)).isFalse();
    }

    @Test
    void ballAroundLight_isNoFullOccluder() {
        assertThat(ballBlocks(new Vec3(0, 0.5, -5), 0, true)).isFalse();
        assertThat(ballBlocks(new Vec3(0, 1.2, -5), 0.3, true)).isFalse();
    }

    @Test
    void ballBeyondLight_isNoFullOccluder() {
        assertThat(ballBlocks(new Vec3(0, -1.5, -5), 0, true)).isFalse();
    }

    /** Uses a ball on a floor, and points under it. */
    private boolean ballBlocks(Vec3 light, double extent, boolean toPoints) {
        Geometry geometry = Geometry.of(TraceScenes.ballOnFloor());
        occlusionTest.setRays(box(-0.2f, -2.5f, -5.2f, 0.2f, -2, -4.8f), light, extent, toPoints, _ -> false);
        assertThat(occlusionTest.isFullOccluder(geometry.primitives(), 1)).as("the floor, which has no inside").isFalse();
        return occlusionTest.isFullOccluder(geometry.primitives(), 0);
    }

    @Test
    void cylinderBetweenRowsAndLight_isFullOccluderOnlyWithCaps() {
        assertThat(cylinderBlocks(true)).isTrue();
        assertThat(cylinderBlocks(false)).isFalse();
    }

    private boolean cylinderBlocks(boolean caps) {
        Geometry geometry = Geometry.of(TraceScenes.singleSolid(new Solid.Cylinder(caps)));
        occlusionTest.setRays(box(-0.2f, -2.5f, -5.2f, 0.2f, -2, -4.8f), new Vec3(0, 4, -5), 0.3, true, _ -> false);
        return occlusionTest.isFullOccluder(geometry.primitives(), 0);
    }

    private static PointBox box(float x, float y, float z, float toX, float toY, float toZ) {
        PointBox box = new PointBox();
        box.set(0, x, toX);
        box.set(1, y, toY);
        box.set(2, z, toZ);
        return box;
    }
}
