package lightning.render.engine.lanes;

import jdk.incubator.vector.DoubleVector;
import lightning.render.trace.CameraRays;
import lightning.render.trace.solid.DoubleLanes;

/** Lane version of {@link CameraRays#pixelRay}, operation by operation. */
final class CameraRayLanes {
    private static final DoubleVector LANE_INDICES = DoubleVector.zero(DoubleLanes.SPECIES).addIndex(1);

    private CameraRayLanes() {}

    /** Writes rays {@code at …} through the pixel {@code column, row} and those to the right of it. */
    static void pixelRays(CameraRays camera, int column, int row, double[] toX, double[] toY, double[] toZ, int at) {
        double y = row + 0.5;
        double downX = y * camera.down.x();
        double downY = y * camera.down.y();
        double downZ = y * camera.down.z();
        for (int h = 0; h < RayPacket.WIDTH; h += DoubleLanes.COUNT) {
            DoubleVector x = LANE_INDICES.add(column + h + 0.5);
            DoubleVector dx = x.mul(camera.right.x()).add(camera.corner.x()).add(downX);
            DoubleVector dy = x.mul(camera.right.y()).add(camera.corner.y()).add(downY);
            DoubleVector dz = x.mul(camera.right.z()).add(camera.corner.z()).add(downZ);
            DoubleVector length = dx.mul(dx).add(dy.mul(dy)).add(dz.mul(dz)).sqrt();
            dx.div(length).intoArray(toX, at + h);
            dy.div(length).intoArray(toY, at + h);
            dz.div(length).intoArray(toZ, at + h);
        }
    }

    /** Writes rays {@code at …} through the image coordinates {@code x[i], y[i]}; both arrays have the length of a packet. */
    static void imageRays(CameraRays camera, double[] x, double[] y, double[] toX, double[] toY, double[] toZ, int at) {
        for (int h = 0; h < RayPacket.WIDTH; h += DoubleLanes.COUNT) {
            DoubleVector imageX = DoubleVector.fromArray(DoubleLanes.SPECIES, x, h);
            DoubleVector imageY = DoubleVector.fromArray(DoubleLanes.SPECIES, y, h);
            DoubleVector dx = imageX.mul(camera.right.x()).add(camera.corner.x()).add(imageY.mul(camera.down.x()));
            DoubleVector dy = imageX.mul(camera.right.y()).add(camera.corner.y()).add(imageY.mul(camera.down.y()));
            DoubleVector dz = imageX.mul(camera.right.z()).add(camera.corner.z()).add(imageY.mul(camera.down.z()));
            DoubleVector length = dx.mul(dx).add(dy.mul(dy)).add(dz.mul(dz)).sqrt();
            dx.div(length).intoArray(toX, at + h);
            dy.div(length).intoArray(toY, at + h);
            dz.div(length).intoArray(toZ, at + h);
        }
    }
}
