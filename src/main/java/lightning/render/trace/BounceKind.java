package lightning.render.trace;

/** How a ray goes on from a row that it met. */
public enum BounceKind {
    /** Mirrored, from every row of a material that mirrors or is clear. */
    MIRRORED {
        @Override
        public int rowCount(HitRows from) {
            return from.reflectiveCount;
        }

        @Override
        public boolean writeDirection(HitRows from, int row, MaterialTable materials, double[] to) {
            SurfacePoint.writeReflection(from.nx[row], from.ny[row], from.nz[row], from.vx[row], from.vy[row], from.vz[row], to);
            return true;
        }

        @Override
        float[] originX(HitRows from) {
            return from.px;
        }

        @Override
        float[] originY(HitRows from) {
            return from.py;
        }

        @Override
        float[] originZ(HitRows from) {
            return from.pz;
        }
    },
    /** Refracted, from every row of a clear material where the surface does not mirror all. */
    REFRACTED {
        @Override
        public int rowCount(HitRows from) {
            return from.transparentCount;
        }

        @Override
        public boolean writeDirection(HitRows from, int row, MaterialTable materials, double[] to) {
            return Refraction.writeDirection(from.nx[row], from.ny[row], from.nz[row], from.vx[row], from.vy[row], from.vz[row],
                    Refraction.eta(materials.transmission(from.material(row)), from.isInside(row)), to);
        }

        @Override
        float[] originX(HitRows from) {
            return from.backX;
        }

        @Override
        float[] originY(HitRows from) {
            return from.backY;
        }

        @Override
        float[] originZ(HitRows from) {
            return from.backZ;
        }
    };

    /** How many rows of a level, the first ones, rays may go on from in this way. */
    public abstract int rowCount(HitRows from);

    /**
     * Writes the direction of the ray that goes on from a row, of length 1.
     *
     * @param to gets x, y, z, {@code double[3]}
     * @return whether a ray goes on; else nothing is written
     */
    public abstract boolean writeDirection(HitRows from, int row, MaterialTable materials, double[] to);

    /** Where rays leave from. */
    abstract float[] originX(HitRows from);

    abstract float[] originY(HitRows from);

    abstract float[] originZ(HitRows from);
}
