package lightning.layer;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.DoubleStream;
import lightning.base.math.Transform;
import lightning.base.math.Vec3;
import lightning.format.exr.ExrAttribute;
import lightning.format.exr.ExrHeader;
import lightning.format.exr.ExrMetadata;
import lightning.scene.Camera;
import lightning.scene.PictureSettings;
import lightning.scene.Scene;
import lightning.scene.World;
import lightning.scene.light.IntensityUnit;
import lightning.scene.value.LensShift;

/**
 * Header of a scene's image by the standard attributes of OpenEXR. Attributes without a known value are absent.
 *
 * <p>Matrices transform row vectors of scene coordinates. Camera space is left-handed: x to the right, y up, z along the view. NDC are
 * 0, 0 in the upper left corner of the image and 1, 1 in the lower right one, after division by w; their z is 1 − 1/z of camera space.
 */
public final class SceneMetadata {
    private SceneMetadata() {}

    /**
     * Returns the attributes of a scene's image.
     *
     * @param frame time of the image in its shot; empty if it is not part of one
     */
    public static Map<String, ExrAttribute> of(Scene scene, Optional<FrameTime> frame) {
        Map<String, ExrAttribute> attributes = new LinkedHashMap<>(ExrMetadata.common());
        // A photometric unit makes a value of 1 a luminance of 1 nit.
        boolean isPhotometric = scene.lights().stream().anyMatch(light -> light.emission().unit() != IntensityUnit.RELATIVE);
        if (isPhotometric) {
            attributes.put("whiteLuminance", new ExrAttribute.Number(1));
        }
        if (isPhotometric || scene.world().meters() != World.METERS.initial()) {
            attributes.put("lightning/metersPerUnit", new ExrAttribute.Number((float) scene.world().meters()));
        }
        frame.ifPresent(time -> {
            attributes.put("imageCounter", new ExrAttribute.Int(time.frame()));
            attributes.put("framesPerSecond", time.fraction());
        });
        addCamera(scene.camera(), scene.picture(), attributes);
        return attributes;
    }

    private static void addCamera(Camera camera, PictureSettings picture, Map<String, ExrAttribute> attributes) {
        Vec3 from = camera.from();
        Vec3 forward = camera.to().minus(from).normalized();
        Vec3 right = forward.cross(camera.up().normalized()).normalized();
        Vec3 up = right.cross(forward);
        double half = camera.fov() / 2;
        double height = 2 * Transform.sinDegrees(half) / Transform.cosDegrees(half);
        double width = height * picture.width() / picture.height();
        attributes.put("worldToCamera",
                matrix(column(right, from, 0), column(up, from, 0), column(forward, from, 0), new double[] {0, 0, 0, 1}));
        Vec3 x = right.times(1 / width).plus(forward.times(0.5 - camera.shift().x()));
        Vec3 y = up.times(-1 / height).plus(forward.times(0.5 + camera.shift().y()));
        attributes.put("worldToNDC", matrix(column(x, from, 0), column(y, from, 0), column(forward, from, -1), column(forward, from, 0)));
        if (!camera.shift().equals(LensShift.NONE)) {
            attributes.put(ExrHeader.SCREEN_WINDOW_CENTER,
                    new ExrAttribute.Point((float) (camera.shift().x() * width), (float) (camera.shift().y() * height)));
        }
        attributes.put(ExrHeader.SCREEN_WINDOW_WIDTH, new ExrAttribute.Number((float) width));
    }

    /** Returns the column of a matrix that maps a point p to {@code (p − from) · axis + offset}. */
    private static double[] column(Vec3 axis, Vec3 from, double offset) {
        return new double[] {axis.x(), axis.y(), axis.z(), offset - axis.dot(from)};
    }

    private static ExrAttribute.Matrix matrix(double[]... columns) {
        double[] values = new double[16];
        for (int i = 0; i < 16; i++) {
            values[i] = columns[i % 4][i / 4];
        }
        List<Float> floats = DoubleStream.of(values).mapToObj(v -> (float) v).toList();
        return new ExrAttribute.Matrix(floats);
    }
}
