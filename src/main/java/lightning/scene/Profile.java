package lightning.scene;

/**
 * How strongly a light shines in each direction, as a goniometer measured it.
 *
 * @param file       the name as written in the scene file
 * @param photometry what the file holds
 */
public record Profile(String file, Photometry photometry) implements FromFile {
    @Override
    public Object content() {
        return photometry;
    }
}
