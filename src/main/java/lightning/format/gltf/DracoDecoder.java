package lightning.format.gltf;

import com.openize.drako.DataType;
import com.openize.drako.Draco;
import com.openize.drako.DracoMesh;
import com.openize.drako.DrakoException;
import com.openize.drako.PointAttribute;
import java.util.List;
import java.util.function.BiFunction;
import lightning.base.work.InterruptibleClasses;

/**
 * Draco's decoder, which an interrupt ends: some damaged data makes it run forever.
 *
 * <p>{@link #interruptible} is an object of a copy of this class and of the library's, so that arguments and results are of types that
 * copies share: from data and ids of attributes, the number of faces, that of points, the indices, and for each attribute its components and its values;
 * null instead of the values of one that is missing, and nothing at all if the data is no mesh.
 */
final class DracoDecoder implements BiFunction<byte[], List<Integer>, Object[]> {
    /** Results before those of attributes, and results for each attribute. */
    static final int FIRST = 3;
    static final int PER_ATTRIBUTE = 3;

    /** Created on first use. */
    private static final class Holder {
        private static final BiFunction<byte[], List<Integer>, Object[]> DECODER = load();
    }

    /** Returns the decoder that an interrupt ends, with an {@link Error}. */
    static BiFunction<byte[], List<Integer>, Object[]> interruptible() {
        return Holder.DECODER;
    }

    @SuppressWarnings("unchecked")
    private static BiFunction<byte[], List<Integer>, Object[]> load() {
        try {
            var constructor = new InterruptibleClasses(DracoDecoder.class.getClassLoader(), DracoDecoder.class.getName(),
                    Draco.class.getPackageName() + ".").loadClass(DracoDecoder.class.getName()).getDeclaredConstructor();
            constructor.setAccessible(true);
            return (BiFunction<byte[], List<Integer>, Object[]>) constructor.newInstance();
        } catch (ReflectiveOperationException e) {
            throw new IllegalStateException(e);
        }
    }

    @Override
    public Object[] apply(byte[] data, List<Integer> ids) {
        try {
            return Draco.decode(data) instanceof DracoMesh mesh ? results(mesh, ids) : new Object[0];
        } catch (DrakoException e) {
            throw new IllegalArgumentException(e);
        }
    }

    private static Object[] results(DracoMesh mesh, List<Integer> ids) {
        var results = new Object[FIRST + PER_ATTRIBUTE * ids.size()];
        results[0] = mesh.getNumFaces();
        results[1] = mesh.getNumPoints();
        results[2] = mesh.getIndices().toArray();
        for (int i = 0; i < ids.size(); i++) {
            for (int k = 0; k < mesh.getNumAttributes(); k++) {
                if (mesh.attribute(k).getUniqueId() == ids.get(i)) {
                    PointAttribute attribute = mesh.attribute(k);
                    results[FIRST + PER_ATTRIBUTE * i] = attribute.getComponentsCount();
                    results[FIRST + PER_ATTRIBUTE * i + 1] = largest(attribute.getDataType());
                    results[FIRST + PER_ATTRIBUTE * i + 2] = values(attribute, mesh.getNumPoints());
                }
            }
        }
        return results;
    }

    /** Returns the largest integer of a short type, which means 1 if it is normalized; 0 for other types. */
    private static int largest(int type) {
        return switch (type) {
            case DataType.UINT8 -> 255;
            case DataType.INT8 -> 127;
            case DataType.UINT16 -> 65535;
            case DataType.INT16 -> 32767;
            default -> 0;
        };
    }

    private static float[] values(PointAttribute attribute, int points) {
        int components = attribute.getComponentsCount();
        float[] values = new float[components * points];
        for (int v = 0; v < points; v++) {
            read(attribute, attribute.mappedIndex(v), values, components * v, components);
        }
        return values;
    }

    private static void read(PointAttribute attribute, int index, float[] out, int at, int components) {
        int type = attribute.getDataType();
        if (type == DataType.FLOAT32) {
            float[] v = new float[components];
            attribute.getValue(index, v);
            System.arraycopy(v, 0, out, at, components);
        } else if (type == DataType.UINT8 || type == DataType.INT8) {
            byte[] v = new byte[components];
            attribute.getValue(index, v);
            for (int c = 0; c < components; c++) {
                out[at + c] = type == DataType.UINT8 ? v[c] & 0xFF : v[c];
            }
        } else if (type == DataType.UINT16 || type == DataType.INT16) {
            short[] v = new short[components];
            attribute.getValue(index, v);
            for (int c = 0; c < components; c++) {
                out[at + c] = type == DataType.UINT16 ? v[c] & 0xFFFF : v[c];
            }
        } else {
            int[] v = new int[components];
            attribute.getValue(index, v);
            for (int c = 0; c < components; c++) {
                out[at + c] = v[c];
            }
        }
    }
}
