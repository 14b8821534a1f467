package lightning.layer;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import lightning.base.math.Ray;
import lightning.format.exr.ExrAttribute;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrType;
import lightning.render.cache.PixelCache;
import lightning.render.engine.Engine;
import lightning.render.trace.Geometry;
import lightning.render.trace.PixelRays;
import lightning.render.trace.SurfaceLocation;
import lightning.render.trace.SurfacePoint;
import lightning.scene.node.Shape;
import tools.jackson.databind.json.JsonMapper;

/**
 * Surface data at the pixels' centers; not averaged over samples, because means of positions, directions or ids are
 * meaningless. The header contains the names of shapes and materials by id.
 *
 * <p>Motion vectors are in Blender's order: the place in the previous frame minus that in this one, then the place in this frame minus that
 * in the next one, each to the right and up.
 */
final class SurfaceChannels implements ChannelSource {
    /** Channels after {@link SurfaceValues}. */
    private static final List<String> PLACE = List.of("shape.id", "material.id", "uv.U", "uv.V");
    private static final List<String> MOTION = List.of("vector.X", "vector.Y", "vector.Z", "vector.W");
    private static final int SHAPE = SurfaceValues.COUNT;
    private static final int COORDINATES = SHAPE + 2;
    private static final int VECTOR = SHAPE + PLACE.size();

    private final PixelCache cache;
    private final List<ExrChannel> channels;
    private final PixelRays eye;
    private final Geometry geometry;
    private final SurfaceValues surfaceValues;
    /** Moves to the previous and to the next frame; empty for an image without motion vectors. */
    private final List<MotionVectors> motion;

    /**
     * @param normalType type of normals and colors; all other channels are FLOAT
     * @param frame frame of the image in its shot; empty for no motion vectors
     */
    SurfaceChannels(PixelCache cache, ExrType normalType, Optional<ShotFrame> frame) {
        this.cache = cache;
        eye = new PixelRays(cache.scene());
        geometry = cache.geometry();
        surfaceValues = SurfaceValues.of(cache);
        motion = frame.map(f -> MotionVectors.of(cache.scene(), f)).orElse(List.of());
        channels = new ArrayList<>(SurfaceValues.channels("", "Z", normalType));
        PLACE.forEach(name -> channels.add(new ExrChannel(name, ExrType.FLOAT)));
        if (frame.isPresent()) {
            MOTION.forEach(name -> channels.add(new ExrChannel(name, ExrType.FLOAT)));
        }
    }

    @Override
    public List<ExrChannel> channels() {
        return channels;
    }

    @Override
    public Map<String, ExrAttribute> attributes() {
        JsonMapper json = new JsonMapper();
        List<String> shapes = cache.scene().stage().shapes().stream().map(Shape::name).toList();
        List<String> materials =
                IntStream.range(0, geometry.materials().count()).mapToObj(m -> geometry.materials().material(m).name()).toList();
        return Map.of("lightning/shapes", new ExrAttribute.Text(json.writeValueAsString(shapes)), "lightning/materials",
                new ExrAttribute.Text(json.writeValueAsString(materials)));
    }

    @Override
    public TileWriter writer(Engine engine) {
        float[] values = new float[channels.size()];
        return (_, _, sink) -> sink.forEachPixel((x, y, _) -> {
            sample(x, y, values);
            for (int i = 0; i < values.length; i++) {
                sink.put(i, x, y, values[i]);
            }
        });
    }

    /** Writes the values of a pixel, in the order of the channels; all except depth and motion are 0 for the background. Faces of lights have
     * no ids. */
    private void sample(int x, int y, float[] out) {
        Ray ray = eye.ray(x, y);
        int primitive = geometry.nearest(ray);
        if (primitive < 0) {
            Arrays.fill(out, 0);
            out[SurfaceValues.DEPTH] = SurfaceValues.BACKGROUND_DEPTH;
            for (int i = 0; i < motion.size(); i++) {
                putMotion(motion.get(i).ofDirection(ray.direction()), i, out);
            }
            return;
        }
        SurfacePoint surface = surfaceValues.write(primitive, ray, out);
        boolean isObject = !geometry.isLightFace(primitive);
        out[SHAPE] = isObject ? geometry.owner(primitive) + 1 : 0;
        out[SHAPE + 1] = isObject ? surface.material() + 1 : 0;
        SurfaceLocation location = geometry.location(primitive, ray);
        out[COORDINATES] = (float) location.u();
        out[COORDINATES + 1] = (float) location.v();
        for (int i = 0; i < motion.size(); i++) {
            putMotion(motion.get(i).ofPoint(geometry.owner(primitive), location, geometry.toScene(location.point())), i, out);
        }
    }

    /**
     * Writes the vector of a neighbor frame.
     *
     * @param move move to that frame, to the right and down
     * @param neighbor 0 for the previous frame, 1 for the next one
     */
    private static void putMotion(double[] move, int neighbor, float[] out) {
        int sign = neighbor == 0 ? 1 : -1;
        // Adding 0 makes −0 positive.
        out[VECTOR + 2 * neighbor] = (float) (sign * move[0] + 0.0);
        out[VECTOR + 2 * neighbor + 1] = (float) (-sign * move[1] + 0.0);
    }
}
