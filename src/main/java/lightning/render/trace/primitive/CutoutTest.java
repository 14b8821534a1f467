package lightning.render.trace.primitive;

import static java.util.Objects.requireNonNull;

import lightning.render.trace.mesh.AlphaTest;
import lightning.render.trace.mesh.MeshSolid;
import lightning.render.trace.mesh.TrianglePoint;
import lightning.scene.asset.TextureMap;
import lightning.scene.material.AlphaCutout;
import org.jspecify.annotations.Nullable;

/** Alpha test of single rays against primitives with cutout materials. Reused; not thread-safe. */
public final class CutoutTest implements AlphaTest {
    private final PrimitiveTable primitives;
    private int s;
    private @Nullable TextureMap map;
    private double cutoff;
    private AlphaCutout.Clip clip = AlphaCutout.Clip.NONE;
    private double ox;
    private double oy;
    private double oz;
    private double dx;
    private double dy;
    private double dz;
    private final BilinearLookup lookup = new BilinearLookup();
    private final TrianglePoint facet = new TrianglePoint();
    private final double[] uv = new double[2];

    public CutoutTest(PrimitiveTable primitives) {
        this.primitives = primitives;
    }

    /** Sets a primitive with cutouts and a ray. */
    public CutoutTest setRay(int primitive, double originX, double originY, double originZ, double directionX, double directionY,
            double directionZ) {
        AlphaCutout cutout = requireNonNull(primitives.cutout(primitive));
        s = primitive;
        map = cutout.hasHoles() ? cutout.map().orElseThrow() : null;
        clip = cutout.clip();
        cutoff = cutout.cutoff();
        ox = originX;
        oy = originY;
        oz = originZ;
        dx = directionX;
        dy = directionY;
        dz = directionZ;
        return this;
    }

    @Override
    public boolean isHole(int part, double t) {
        double x = ox + t * dx;
        double y = oy + t * dy;
        double z = oz + t * dz;
        double[] m = primitives.data;
        int i = primitives.dataStart[s];
        double localX = m[i] * x + m[i + 1] * y + m[i + 2] * z + m[i + 3];
        double localY = m[i + 4] * x + m[i + 5] * y + m[i + 6] * z + m[i + 7];
        double localZ = m[i + 8] * x + m[i + 9] * y + m[i + 10] * z + m[i + 11];
        if (clip != AlphaCutout.Clip.NONE) {
            boolean isCorner = clip == AlphaCutout.Clip.BACK_AND_CORNERS && localX * localX + localZ * localZ > 0.25;
            if (isCorner || m[i + 4] * dx + m[i + 5] * dy + m[i + 6] * dz >= 0) {
                return true;
            }
        }
        if (map == null) {
            return false;
        }
        MeshSolid mesh = primitives.mesh(s);
        if (mesh == null) {
            primitives.kind(s).geometry().textureCoordinates(m, i, localX, localY, localZ, uv);
        } else {
            facet.setPoint(mesh.mesh(), part, localX, localY, localZ);
            uv[0] = facet.textureCoordinate(0);
            uv[1] = facet.textureCoordinate(1);
        }
        lookup.setCoordinates(map, uv[0], uv[1]);
        return lookup.red() < cutoff;
    }
}
