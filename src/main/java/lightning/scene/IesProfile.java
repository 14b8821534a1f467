package lightning.scene;

/**
 * How strongly a light shines in each direction, as a goniometer measured it.
 *
 * @param file       the name as written in the scene file
 * @param photometry what the file holds
 */
public record IesProfile(String file, Photometry photometry) implements FileAsset {
    @Override
    public Object content() {
        return photometry;
    }
}
