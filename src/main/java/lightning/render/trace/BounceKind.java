package lightning.render.trace;

import static java.util.Objects.requireNonNull;

import lightning.render.trace.HitRows.ColumnGroup;

/** Kind of secondary ray that leaves a hit row: reflected or refracted. */
public enum BounceKind {
    /** Reflected ray, cast from every row of a reflective or transparent material. */
    MIRRORED {
        @Override
        public int rowCount(HitRows from) {
            return from.reflectiveCount;
        }

        @Override
        public boolean writeDirection(HitRows from, int row, MaterialTable materials, double[] to) {
            float[] coatX = from.texel(ColumnGroup.COAT_NORMAL, 0);
            if (coatX != null && materials.material(from.material(row)).coatNormals().mirrors()) {
                SurfacePoint.writeReflection(coatX[row], requireNonNull(from.texel(ColumnGroup.COAT_NORMAL, 1))[row],
                        requireNonNull(from.texel(ColumnGroup.COAT_NORMAL, 2))[row], from.vx[row], from.vy[row], from.vz[row], to);
            } else {
                SurfacePoint.writeReflection(from.nx[row], from.ny[row], from.nz[row], from.vx[row], from.vy[row], from.vz[row], to);
            }
            return true;
        }

        @Override
        public float[] originX(HitRows from) {
            return from.px;
        }

        @Override
        public float[] originY(HitRows from) {
            return from.py;
        }

        @Override
        public float[] originZ(HitRows from) {
            return from.pz;
        }
    },
    /** Refracted ray, cast from every row of a transparent material unless reflection is total. */
    REFRACTED {
        @Override
        public int rowCount(HitRows from) {
            return from.clearCount;
        }

        @Override
        public boolean writeDirection(HitRows from, int row, MaterialTable materials, double[] to) {
            return Refraction.writeDirection(from.nx[row], from.ny[row], from.nz[row], from.vx[row], from.vy[row], from.vz[row],
                    Refraction.eta(materials.transmission(from.material(row)), from.isInside(row)), to);
        }

        @Override
        public float[] originX(HitRows from) {
            return requireNonNull(from.backX);
        }

        @Override
        public float[] originY(HitRows from) {
            return requireNonNull(from.backY);
        }

        @Override
        public float[] originZ(HitRows from) {
            return requireNonNull(from.backZ);
        }
    };

    /** Returns how many rows of a level cast rays of this kind; they are the first rows. */
    public abstract int rowCount(HitRows from);

    /**
     * Writes the direction, of length 1, of the secondary ray from a row.
     *
     * @param to receives x, y, z, {@code double[3]}
     * @return true if the row casts a ray; otherwise nothing is written
     */
    public abstract boolean writeDirection(HitRows from, int row, MaterialTable materials, double[] to);

    /** Origins of the rays, one per row. */
    public abstract float[] originX(HitRows from);

    public abstract float[] originY(HitRows from);

    public abstract float[] originZ(HitRows from);
}
