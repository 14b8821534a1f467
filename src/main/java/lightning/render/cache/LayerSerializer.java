package lightning.render.cache;

import java.io.IOException;
import lightning.render.column.ColumnReader;
import lightning.render.column.ColumnWriter;
import lightning.render.shading.layer.LightLayer;
import lightning.render.shading.layer.LightRows;

/** Serializer of the layers of lights over some rows. */
final class LayerSerializer {
    private LayerSerializer() {}

    /** @param layers layers of accuracy exact; null for lights that were never on */
    static void write(LightLayer[] layers, ColumnWriter out) throws IOException {
        out.writeInt(layers.length);
        for (LightLayer layer : layers) {
            out.writeInt(layer == null ? 0 : 1);
            if (layer != null) {
                ((LightRows) layer).writeTo(out);
            }
        }
    }

    static LightLayer[] read(ColumnReader in) throws IOException {
        LightLayer[] layers = new LightLayer[in.readCount()];
        for (int i = 0; i < layers.length; i++) {
            layers[i] = in.readInt() == 0 ? null : LightRows.readFrom(in);
        }
        return layers;
    }
}
