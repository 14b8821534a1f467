package lightning.format.exchange.assembly;

import java.util.Map;

/**
 * Lights of a scene in the format of another program.
 *
 * @param bytes content of the output file
 * @param files content of further files next to it, by their names
 * @param notes properties that the format does not support, with their counts
 */
public record ExportedLights(byte[] bytes, Map<String, byte[]> files, Map<String, Integer> notes) {
    // Arrays in a record: written once by their creator.
}
