-- Text as files of XML and SVG may hold it.

CREATE OR REPLACE FUNCTION streetgen._xml_text(words text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN regexp_replace(words, '[\x01-\x08\x0b\x0c\x0e-\x1f\ufffe\uffff]', '', 'g');
COMMENT ON FUNCTION streetgen._xml_text(text) IS 'A text without the characters that XML cannot hold.';

CREATE OR REPLACE FUNCTION streetgen._as_xml(words text) RETURNS text
    LANGUAGE sql IMMUTABLE PARALLEL SAFE
    RETURN replace(replace(replace(streetgen._xml_text(words), '&', '&amp;'), '<', '&lt;'), '"', '&quot;');
COMMENT ON FUNCTION streetgen._as_xml(text) IS 'A text as a file of XML writes it, also between quotation marks.';
