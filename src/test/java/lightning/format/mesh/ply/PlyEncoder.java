package lightning.format.mesh.ply;

import java.io.ByteArrayOutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/** Converter of PLY files from text to binary form with the same numbers, in either byte order. */
public final class PlyEncoder {
    private PlyEncoder() {}

    /** Encodes a text file in one of the three forms. */
    public static byte[] encode(String format, String text) {
        if (format.equals("ascii")) {
            return text.getBytes(StandardCharsets.UTF_8);
        }
        int headerEnd = text.indexOf("end_header\n") + "end_header\n".length();
        String header = text.substring(0, headerEnd).replace("format ascii", "format " + format);
        var out = new ByteArrayOutputStream();
        out.writeBytes(header.getBytes(StandardCharsets.UTF_8));
        ByteOrder order = format.contains("little") ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
        var words = Arrays.asList(text.substring(headerEnd).strip().split("\\s+")).iterator();
        String[] lines = header.split("\n");
        for (int i = 0; i < lines.length; i++) {
            if (lines[i].startsWith("element ")) {
                int count = Integer.parseInt(lines[i].split(" ")[2]);
                int last = i + 1;
                while (lines[last].startsWith("property ")) {
                    last++;
                }
                for (int element = 0; element < count; element++) {
                    for (int p = i + 1; p < last; p++) {
                        String[] property = lines[p].split(" ");
                        int numbers = 1;
                        if (property[1].equals("list")) {
                            String length = words.next();
                            numbers = Integer.parseInt(length);
                            out.writeBytes(number(property[2], length, order));
                        }
                        for (int n = 0; n < numbers; n++) {
                            out.writeBytes(number(property[property.length - 2], words.next(), order));
                        }
                    }
                }
            }
        }
        return out.toByteArray();
    }

    private static byte[] number(String type, String word, ByteOrder order) {
        ByteBuffer b = ByteBuffer.allocate(8).order(order);
        switch (type) {
            case "char", "uchar", "int8", "uint8" -> b.put((byte) Integer.parseInt(word));
            case "short", "ushort", "int16", "uint16" -> b.putShort((short) Integer.parseInt(word));
            case "int", "uint", "int32", "uint32" -> b.putInt((int) Long.parseLong(word));
            case "float", "float32" -> b.putFloat(Float.parseFloat(word));
            default -> b.putDouble(Double.parseDouble(word));
        }
        return Arrays.copyOf(b.array(), b.position());
    }
}
