package lightning.layer;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import lightning.format.exr.ExrAttribute;
import lightning.format.exr.ExrChannel;
import lightning.format.exr.ExrCompression;
import lightning.format.exr.ExrHeader;
import lightning.format.exr.ExrType;
import lightning.format.exr.ExrWindow;

/**
 * Parts of a file: one with all channels, or one of each layer. Channels keep their names, so that a file has the same channels either way.
 * The first part is the image, and has the attributes of all channels.
 *
 * @param headers header of each part
 */
record LayerParts(List<ExrHeader> headers) {
    private static final String IMAGE = "rgba";
    private static final String DEPTH = "depth";
    /** Channel of depth, which has no layer. */
    private static final String DEPTH_CHANNEL = "Z";

    /** Place of a channel: number of its part, and its index in the part's header. */
    record Slot(int part, int channel) {}

    /**
     * Distributes channels to parts.
     *
     * @param channels channels in the order of their parts; those of the image first
     * @param common attributes of all parts
     * @param others attributes of the first part only
     */
    static LayerParts of(List<ExrChannel> channels, Map<String, ExrAttribute> common, Map<String, ExrAttribute> others, ExrLayout layout,
            ImageCrop crop, ExrWindow window) {
        Map<String, List<ExrChannel>> parts = new LinkedHashMap<>();
        channels.forEach(channel -> parts.computeIfAbsent(layout.hasParts() ? part(channel) : IMAGE, _ -> new ArrayList<>()).add(channel));
        List<ExrHeader> headers = new ArrayList<>();
        parts.forEach((name, some) -> {
            Map<String, ExrAttribute> attributes = new LinkedHashMap<>(common);
            if (headers.isEmpty()) {
                attributes.putAll(others);
            }
            if (parts.size() > 1) {
                attributes.put(ExrHeader.NAME, new ExrAttribute.Text(name));
            }
            ExrCompression compression = parts.size() > 1 ? compression(some, layout.compression()) : layout.compression();
            headers.add(new ExrHeader(crop.width(), crop.height(), some, attributes, compression, window));
        });
        return new LayerParts(headers);
    }

    private static String part(ExrChannel channel) {
        int dot = channel.name().lastIndexOf('.');
        return dot >= 0 ? channel.name().substring(0, dot) : channel.name().equals(DEPTH_CHANNEL) ? DEPTH : IMAGE;
    }

    /** Returns the compression of a part: ZIP for one that has nothing to lose, because that is smaller for floats. */
    private static ExrCompression compression(List<ExrChannel> channels, ExrCompression chosen) {
        boolean hasColors = channels.stream().anyMatch(c -> c.type() == ExrType.HALF && List.of("R", "G", "B").contains(c.suffix()));
        return chosen.isDwa() && !hasColors ? ExrCompression.ZIP : chosen;
    }

    /** Returns the place of a channel. */
    Slot slot(ExrChannel channel) {
        for (int part = 0; part < headers.size(); part++) {
            int index = headers.get(part).channels().indexOf(channel);
            if (index >= 0) {
                return new Slot(part, index);
            }
        }
        throw new IllegalArgumentException("no part has the channel " + channel.name());
    }

    /** Returns the uncompressed bytes of a line of all parts. */
    long bytesPerLine() {
        return headers.stream().mapToLong(ExrHeader::bytesPerLine).sum();
    }
}
